const PREFIX = '@group ';

/** The key of the row of a group among the rows of objects, whose keys never begin like this. */
export const groupRowKey = (group: string): string => `${PREFIX}${group}`;
