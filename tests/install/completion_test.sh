#!/bin/bash
# Tests man pages and completions as man and the shells use them. Shells that are not installed here are left out, with a message.
# Usage: tests/install/completion_test.sh BUILD
# shellcheck disable=SC2034  # COMP_WORDS and COMP_CWORD are read by the functions that are sourced
set -uo pipefail

build=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly build here scratch completions=$build/completions
failed=0

verdict() {
    if [[ $2 == "$3" ]]; then
        echo "ok $1"
    else
        failed=1
        printf 'FAILED %s\n  expected: %s\n  instead:  %s\n' "$1" "$2" "$3"
    fi
}

# Prints the completions of bash for the last word, on one line.
completed() {
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    COMPREPLY=()
    local found
    found=$(complete -p "$1")
    [[ $found =~ -F\ ([a-z0-9_]+) ]] && "${BASH_REMATCH[1]}"
    (IFS=,; echo "${COMPREPLY[*]}")
}

touch "$scratch/a part.nc" "$scratch/b.toml"
mkdir "$scratch/folder"
cd "$scratch" || exit

bash -n "$completions/gsim.bash" || failed=1
# shellcheck source=/dev/null
source "$completions/gsim.bash"
verdict 'bash: commands' 'check,completion' "$(completed gsim c)"
verdict 'bash: shells' 'bash' "$(completed gsim completion b)"
verdict 'bash: help of a command' 'translate' "$(completed gsim help t)"
verdict 'bash: options' '--machine,--machine-data' "$(completed gsim run --mach)"
verdict 'bash: by its name' '--machine,--machine-data' "$(completed gsim-run part.nc --mach)"
verdict 'bash: choices' 'error,warn' "$(completed gsim-run --unknown '')"
verdict 'bash: choices after =' 'rs274ngc' "$(completed gsim-run --dialect = r)"
verdict 'bash: choices at =' 'error,warn' "$(completed gsim-run --unknown =)"
verdict 'bash: names of controls' 'haas' "$(completed gsim-run --dialect h)"
verdict 'bash: files with spaces' 'a part.nc' "$(completed gsim-run a)"
verdict 'bash: files of options' 'b.toml' "$(completed gsim check --machine b)"
verdict 'bash: folders' 'folder' "$(completed gsim-run --lua-lib '')"
verdict 'bash: a number is the user'"'"'s' '' "$(completed gsim-run --max-time '')"
verdict 'bash: commands of gsim-data' 'list' "$(completed gsim-data jet.txt l)"

# Programs that are not part of gsim have separate scripts.
own=()
for script in "$completions"/gsim-*.bash; do own+=("$(basename "$script" .bash)"); done
[[ ${own[*]} == *gsim-batch*gsim-optimise* ]] || failed=1
for name in "${own[@]}"; do
    bash -n "$completions/$name.bash" || failed=1
    # shellcheck source=/dev/null
    source "$completions/$name.bash"
done
verdict 'bash: options of gsim-batch' '--machine,--machine-data' "$(completed gsim-batch --mach)"
verdict 'bash: options of gsim-optimise' '--best' "$(completed gsim-optimise b.toml --be)"
verdict 'bash: files of gsim-optimise' 'b.toml' "$(completed gsim-optimise b)"

if command -v zsh >/dev/null; then
    for name in "${own[@]}"; do verdict "zsh: syntax of $name" '' "$(zsh -n "$completions/$name.zsh" 2>&1)"; done
    verdict 'zsh: syntax' '' "$(zsh -n "$completions/gsim.zsh" 2>&1)"
    mkdir "$scratch/functions"
    cp "$completions/gsim.zsh" "$scratch/functions/_gsim"
    zsh_completed() {
        timeout 60 zsh -f "$here/zsh_completed.zsh" "$scratch/functions" "$1" | paste -sd,
    }
    for name in "${own[@]}"; do cp "$completions/$name.zsh" "$scratch/functions/_$name"; done
    verdict 'zsh: options of gsim-optimise' '--best' "$(zsh_completed 'gsim-optimise --be')"
    verdict 'zsh: files of gsim-batch' 'b.toml' "$(zsh_completed 'gsim-batch --machine b')"
    verdict 'zsh: commands' 'check,completion' "$(zsh_completed 'gsim c')"
    verdict 'zsh: shells' 'bash' "$(zsh_completed 'gsim completion b')"
    verdict 'zsh: options' '--machine,--machine-data' "$(zsh_completed 'gsim run --mach')"
    verdict 'zsh: by its name' '--machine,--machine-data' "$(zsh_completed 'gsim-run part.nc --mach')"
    verdict 'zsh: choices' 'error,warn' "$(zsh_completed 'gsim-run --unknown ')"
    verdict 'zsh: files' 'b.toml' "$(zsh_completed 'gsim check --machine b')"
    verdict 'zsh: commands of gsim-data' 'list' "$(zsh_completed 'gsim-data jet.txt l')"
else
    echo 'skipped: no zsh here'
fi

if command -v fish >/dev/null; then
    export HOME=$scratch XDG_CONFIG_HOME=$scratch XDG_DATA_HOME=$scratch
    verdict 'fish: syntax' '' "$(fish --no-execute "$completions/gsim.fish" 2>&1)"
    fish_completed() {
        fish --no-config --command "source '$completions/gsim.fish'; complete --do-complete '$1'" | cut -f1 | paste -sd,
    }
    for name in "${own[@]}"; do verdict "fish: syntax of $name" '' "$(fish --no-execute "$completions/$name.fish" 2>&1)"; done
    verdict 'fish: options of gsim-optimise' '--best' \
        "$(fish --no-config --command "source '$completions/gsim-optimise.fish'; complete --do-complete 'gsim-optimise --be'" | cut -f1 | paste -sd,)"
    verdict 'fish: commands' 'check,completion' "$(fish_completed 'gsim c')"
    verdict 'fish: shells' 'bash' "$(fish_completed 'gsim completion b')"
    verdict 'fish: options' '--machine,--machine-data' "$(fish_completed 'gsim run --mach')"
    verdict 'fish: by its name' '--machine,--machine-data' "$(fish_completed 'gsim-run part.nc --mach')"
    verdict 'fish: choices' 'error,warn' "$(fish_completed 'gsim-run --unknown ')"
    verdict 'fish: files' 'b.toml' "$(fish_completed 'gsim check --machine b')"
else
    echo 'skipped: no fish here'
fi

for page in "$build"/man/*.1; do
    if command -v man >/dev/null; then
        verdict "man: ${page##*/}" '' "$(MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings --encoding=utf8 --local-file "$page" 2>&1 >/dev/null)"
    else
        echo "skipped: no man here for ${page##*/}"
    fi
    verdict "its name in the index: ${page##*/}" 1 "$(grep -c "^$(basename "$page" .1 | sed 's/-/\\\\-/') \\\\- " "$page")"
done
exit "$failed"
