import type { GhostSource, Play } from 'gravity-quest-toolkit/game';
import type { Level } from './pack.ts';
import type { GhostChoice } from './settings.ts';

export type Hold = GhostSource['holds'][number];

/** A play that somebody has sent. */
export interface Rival {
  readonly name: string;
  readonly holds: readonly Hold[];
  readonly claim: Play['claim'];
}

/**
 * The runs that are shown beside a play.
 * @param best the holds of the best play so far
 */
export function ghostsOf(level: Level, best: readonly Hold[] | null, choice: GhostChoice, rival: Rival | null): GhostSource[] {
  const ghosts: GhostSource[] = [];
  if (rival !== null) ghosts.push({ name: rival.name, holds: rival.holds });
  if (choice !== 'none' && best !== null) ghosts.push({ name: 'best', holds: best });
  if (choice === 'all' && level.runs.length > 0) ghosts.push({ name: level.runs[0].name, holds: level.runs[0].holds });
  return ghosts;
}
