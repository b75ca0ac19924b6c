/** A level gets at most this many warnings of one code, plus one that says that there are more. */
export const MAX_WARNINGS_PER_CODE = 20;

/** The message of that additional warning. */
export const MORE_WARNINGS = `the level has more warnings of this kind: only the first ${MAX_WARNINGS_PER_CODE} are listed`;
