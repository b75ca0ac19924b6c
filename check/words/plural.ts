/** Formats a number with its noun: `1 level`, `2 levels`. */
export const plural = (count: number, one: string, many = `${one}s`): string => `${count} ${count === 1 ? one : many}`;
