import { isTaken, moveFile } from '../io/index.ts';
import { pathOfNew } from './level-files.ts';
import { nameTaken } from './refusals.ts';
import { inSafeOrder, type Move } from './reorder.ts';

/**
 * Renames the files of levels: all or none.
 * @param nameOf the path of a level as the user sees it
 * @throws Refusal if a name is taken
 */
export function moveAll(root: string, moves: readonly Move[], nameOf: (id: string) => string): void {
  const pathIn = (id: string): string => pathOfNew(root, '', id);
  const aside = (id: string): string => {
    for (let n = 1; ; n++) if (!isTaken(pathIn(`${id}-moved-${n}`))) return `${id}-moved-${n}`;
  };
  const done: Move[] = [];
  try {
    for (const move of inSafeOrder(moves, aside)) {
      if (!moveFile(pathIn(move.from), pathIn(move.to))) throw nameTaken(nameOf(move.to));
      done.push(move);
    }
  } catch (error) {
    for (const { from, to } of done.reverse()) moveFile(pathIn(to), pathIn(from));
    throw error;
  }
}
