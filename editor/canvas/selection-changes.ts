import type { Editor, OpenLevel } from '../core/context/index.ts';
import {
  type ChangeResult,
  type LinearMap,
  mapObjects,
  mapProblem,
  mirrorAlong,
  type ObjectKey,
  type Recipe,
  scaleObjects,
  turnBy,
  unlocked,
} from '../core/document/index.ts';
import { centreOf, extentOf } from './extent.ts';

/** Changes of the selection by commands. */
export interface ObjectChanges {
  /** What must be selected first for a command; null if enough is. */
  readonly needsSelected: (least: 1 | 2 | 3) => () => string | null;
  /** The selected objects that are not locked; if all are locked, says so and returns none. */
  readonly free: () => readonly ObjectKey[];
  /** Says why something is not done. */
  readonly refuse: (why: string) => void;
  /** Changes the level; a refusal is shown as a notice. @param gesture changes with the same gesture form one step */
  readonly change: (label: string, recipe: Recipe, gesture?: string) => ChangeResult;
  /** Changes the level and selects the added objects. */
  readonly add: (label: string, recipe: Recipe) => void;
}

const LOCKED = 'What is selected is locked.';

export function objectChanges({ notices, commands }: Editor, { document, selection }: OpenLevel): ObjectChanges {
  const change = (label: string, recipe: Recipe, gesture?: string): ChangeResult => {
    const result = document.change(label, recipe, gesture === undefined ? {} : { gesture });
    if (!result.ok) notices.refuse(result.refusal);
    return result;
  };
  return {
    needsSelected: (least) => () =>
      selection.keys().length >= least ? null : `select ${['an object', 'two objects', 'three objects'][least - 1]} first`,
    free() {
      const keys = unlocked(document.file(), selection.keys());
      if (keys.length === 0 && selection.keys().length > 0) {
        const actions = [{ title: 'Unlock', run: () => void commands.run('object.lock') }];
        notices.show('info', LOCKED, { topic: 'refused', actions });
      }
      return keys;
    },
    refuse: (why) => void notices.show('warning', why, { topic: 'refused' }),
    change,
    add(label, recipe) {
      const result = change(label, recipe);
      if (result.ok && result.added.length > 0) selection.select(result.added);
    },
  };
}

/** Changes the selection about the middle of its box; locked objects stay. A refusal is shown as a notice. */
interface TransformActions {
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
