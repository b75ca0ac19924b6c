import type { StoreApi } from 'zustand/vanilla';
import type { Ghost } from '../../core/context/index.ts';

/** The ghosts on the canvas: paths beside that of the shown run. */
export interface GhostShelf {
  readonly ghosts: StoreApi<readonly Ghost[]>;
}

/** Replaces the ghosts of one look; those of other looks stay. */
export function putGhosts({ ghosts }: GhostShelf, look: Ghost['look'], wanted: readonly Ghost[]): void {
  const now = ghosts.getState();
  const others = now.filter((ghost) => ghost.look !== look);
  if (wanted.length === 0 && others.length === now.length) return;
  ghosts.setState([...others, ...wanted], true);
}
