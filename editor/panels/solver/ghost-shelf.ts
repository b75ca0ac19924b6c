import type { StoreApi } from 'zustand/vanilla';
import type { Ghost } from '../../context/index.ts';

/** Where ways beside that of the run are put for the canvas. */
export interface GhostShelf {
  readonly ghosts: StoreApi<readonly Ghost[]>;
}

/** Puts other ghosts of one look on the canvas; those of others stay. */
export function putGhosts({ ghosts }: GhostShelf, look: Ghost['look'], wanted: readonly Ghost[]): void {
  const now = ghosts.getState();
  const others = now.filter((ghost) => ghost.look !== look);
  if (wanted.length === 0 && others.length === now.length) return;
  ghosts.setState([...others, ...wanted], true);
}
