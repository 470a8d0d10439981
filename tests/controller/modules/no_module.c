/* A library, but no controller module. */

int answer(void);

int answer(void) {
    return 42;
}
