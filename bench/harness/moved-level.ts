import { KINDS, type LevelFile, LISTED_KINDS, listOf, type ObjectKind, SINGLE_KINDS } from '../../schema/index.ts';

/** The level with everything moved by (dx, dy) px: a different file with the same verdict. */
export function movedLevel(file: LevelFile, dx: number, dy: number): LevelFile {
  const move = <T extends object>(kind: ObjectKind, object: T): T => {
    const moved = { ...object } as Record<string, unknown>;
    for (const [x, y] of KINDS[kind].places) {
      moved[x] = (moved[x] as number) + dx;
      moved[y] = (moved[y] as number) + dy;
    }
    return moved as T;
  };
  const moved: Record<string, unknown> = { ...file };
  for (const kind of SINGLE_KINDS) moved[kind] = move(kind, file[kind]);
  for (const kind of LISTED_KINDS) {
    const list = listOf(kind);
    if (file[list] !== undefined) moved[list] = file[list].map((object) => move(kind, object));
  }
  return moved as unknown as LevelFile;
}
