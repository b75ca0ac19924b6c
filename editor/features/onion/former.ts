import type { Box, Terms } from '../../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../../schema/index.ts';
import { type LiveProof, pathOf, playsAlike } from '../../core/proof/index.ts';
import { type Figures, figuresOf } from './figures.ts';

/** The shown run as it was before a change: copied, as the arrays of a proof are overwritten by the next one. */
export interface FormerRun {
  readonly file: LevelFile;
  readonly level: Level;
  /** Under which it was played. */
  readonly terms: Terms;
  /** The astronaut's collision box. */
  readonly her: Box;
  /** null: the level had no run, she drifted */
  readonly name: string | null;
  readonly holds: readonly Hold[];
  readonly figures: Figures;
  /** x, y in px, two entries per tick, and those at the end */
  readonly points: Float32Array;
}

/** Copies the shown run. */
export function formerOf(proof: LiveProof): FormerRun {
  const { file, level, terms, scene, run } = proof;
  const { name, holds, way } = run;
  return { file, level, terms, her: scene.box, name, holds, figures: figuresOf(proof), points: pathOf(way) };
}

/** Whether it is the run that is shown now, under the same terms. */
export const isShown = ({ name, terms }: FormerRun, now: Pick<LiveProof, 'run' | 'terms'>): boolean =>
  name === now.run.name && terms === now.terms;

/** Whether nothing is different that the run depends on: only a name, say. */
export const playsLike = (former: FormerRun, now: LiveProof): boolean =>
  playsAlike(former, now) && former.holds.join() === now.run.holds.join();
