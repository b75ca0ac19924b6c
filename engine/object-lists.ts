import type { Level } from '../schema/basics/index.ts';

/**
 * The lists of objects of a level by name: all its lists but the runs. The table of kinds names them too, but a small game does
 * not bundle it.
 */
export const objectLists = (level: Level): [name: string, objects: readonly unknown[]][] =>
  Object.entries(level).filter(([name, value]) => Array.isArray(value) && name !== 'runs');
