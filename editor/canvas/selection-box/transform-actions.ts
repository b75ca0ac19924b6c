import type { OpenLevel } from '../../core/context/index.ts';
import { type LinearMap, mapObjects, mapProblem, mirrorAlong, scaleObjects, turnBy } from '../../core/document/index.ts';
import { extentOf } from '../extent.ts';
import type { ObjectChanges } from '../object-changes.ts';
import { centreOf } from './box.ts';

/** Changes the selection about the middle of its box; locked objects stay. A refusal is shown as a notice. */
export interface TransformActions {
  /** Clockwise. @param gesture turns with the same gesture form one step */
  turn(degrees: number, gesture?: string): void;
  /** `x`: left and right are exchanged */
  mirror(axis: 'x' | 'y'): void;
  /** Scales the distances from the middle. @param withRadii whether radii scale, too */
  scale(factor: number, withRadii: boolean): void;
}

export function transformActions(
  { document, proof }: OpenLevel,
  { free, change, refuse }: Pick<ObjectChanges, 'free' | 'change' | 'refuse'>,
): TransformActions {
  const middle = (keys: Iterable<string>) => {
    const box = extentOf(document.file(), proof.proof().scene.box, keys);
    return box === null ? null : centreOf(box);
  };
  const mapBy = (label: string, map: LinearMap, gesture?: string) => {
    const keys = free();
    const centre = middle(keys);
    if (centre === null) return;
    const problem = mapProblem(document.file(), keys, map);
    if (problem !== null) refuse(problem);
    else change(label, mapObjects(keys, centre, map), gesture);
  };
  return {
    turn: (degrees, gesture) => mapBy('Turn', turnBy(degrees), gesture),
    mirror: (axis) => mapBy('Mirror', mirrorAlong(axis)),
    scale(factor, withRadii) {
      const keys = free();
      const from = middle(keys);
      if (from === null) return;
      change('Scale', scaleObjects(document.file(), keys, { from, x: factor, y: factor, radii: withRadii ? factor : 1 }));
    },
  };
}
