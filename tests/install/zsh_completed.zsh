# What zsh offers for a line, one a line. Completion works only in a shell that somebody types into, so one is typed into here.
# Usage: zsh -f tests/install/zsh_completed.zsh FOLDER LINE; FOLDER has _gsim, and room for a file
zmodload zsh/zpty

# What is offered is caught where it is added. With -O, -A and -D nothing is: those ask what would match.
cat >$1/typed_into <<END
PS1=
fpath=(${(q)1} \$fpath)
autoload -Uz compinit && compinit -D -u
compadd() {
    if [[ \${@[1,(i)(-|--)]} != *-(O|A|D)\ * ]]; then
        local -a offered
        builtin compadd -A offered "\$@"
        ((\$#offered)) && print -rl -- '<offer>'\$^offered
    fi
    builtin compadd "\$@"
}
told() { zle -I; _main_complete; compstate[insert]= compstate[list]=; print '<end>' }
zle -C told complete-word told
bindkey '^I' told
print '<ready>'
END

zpty -b shell zsh -f -i
zpty -w shell "source ${(q)1}/typed_into"
zpty -r shell text '*<ready>*'
zpty -w -n shell "$2"$'\t'
zpty -r shell text '*<end>*'
zpty -d shell
for line in ${(f)text}; do
    [[ $line == *'<offer>'* ]] && print -r -- ${${line#*'<offer>'}%$'\r'}
done | sort -u
