import {
  appearanceOfObject,
  KINDS,
  type Level,
  LISTED_KINDS,
  type ListedKind,
  listOf,
  objectName,
  objectsIn,
} from '../../schema/basics/index.ts';
import { ALL_EFFECTS } from '../effects/index.ts';

/** A solid circle of a level, which she may touch. Lengths are in px. */
export interface Body {
  readonly kind: ListedKind | 'blackHole';
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** Index within the level's list of that kind, from 0. */
  readonly index: number;
  /** Its name in a sentence: `nova 3`, `the black hole`. */
  readonly name: string;
  /** Whether touching it ends a run with `collided`. */
  readonly isHazard: boolean;
  /** Whether it stays where the level places it during a whole run. */
  readonly staysPut: boolean;
}

/** The kinds of which an object can be deadly: all their objects are drawn solid. */
const SOLID = LISTED_KINDS.filter((kind) => KINDS[kind].deadly || KINDS[kind].variant?.deadly === true);

/** The solid objects of a level in the order of a file, then the black hole. */
export function bodiesOf(level: Level): Body[] {
  const bodies: Body[] = [];
  for (const kind of SOLID) {
    const chases = ALL_EFFECTS.hasChaser(kind);
    // recoil moves what the gun targets
    const stays = !chases && !(kind === 'asteroid' && level.recoil);
    for (const [index, object] of objectsIn(level, kind).entries()) {
      const { x, y, radius } = object;
      const isHazard = appearanceOfObject(kind, object).deadly;
      bodies.push({ kind, x, y, radius, index, name: objectName(kind, index, object), isHazard, staysPut: stays });
    }
  }
  const { x, y, radius } = level.blackHole;
  bodies.push({ kind: 'blackHole', x, y, radius, index: 0, name: 'the black hole', isHazard: false, staysPut: true });
  return bodies;
}

/** The JSON pointer of a body in the level file. */
export const pointerOf = ({ kind, index }: Body): string => (kind === 'blackHole' ? '/blackHole' : `/${listOf(kind)}/${index}`);

/** A length in words: px with at most three decimals. */
export const px = (length: number): string => `${Math.round(length * 1000) / 1000} px`;

export interface Place {
  readonly x: number;
  readonly y: number;
}

export interface Disc extends Place {
  readonly radius: number;
}

/** Distance between two places, px. */
export function distance(a: Place, b: Place): number {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Whether the whole of `disc` lies inside `by`, so that touching the one means touching the other. */
export const covers = (by: Disc, disc: Disc): boolean => distance(by, disc) + disc.radius <= by.radius;
