import type { IndexedCircles } from './indexed-circles.ts';
import type { Scene } from './scene.ts';
import type { BodyKind } from './simulation.ts';

/** Circles of one kind that end a run on touch. */
export interface HazardList {
  readonly kind: BodyKind;
  readonly circles: IndexedCircles;
  /** The first of the circles that is deadly. */
  readonly first: number;
  /** What moves them during a run: nothing, recoil as it moves asteroids, or a chase. */
  readonly movedBy: 'nothing' | 'recoil' | 'chase';
}

/** All hazards of a scene. Of equally near ones the first in this order counts. */
export const hazardLists = ({ novae, targets, coldCount, aliens }: Scene): readonly HazardList[] => [
  { kind: 'nova', circles: novae, first: 0, movedBy: 'nothing' },
  { kind: 'asteroid', circles: targets, first: coldCount, movedBy: 'recoil' },
  { kind: 'alien', circles: aliens, first: 0, movedBy: 'chase' },
];

/** The number of hazards of a scene. */
export const hazardCount = (scene: Scene): number =>
  hazardLists(scene).reduce((sum, { circles, first }) => sum + circles.count - first, 0);
