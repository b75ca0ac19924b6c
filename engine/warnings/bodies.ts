import { type Level, objectName } from '../../schema/basics/index.ts';

/** A solid circle of a level, which she may touch. Lengths are in px. */
export interface Body {
  readonly kind: 'asteroid' | 'hot asteroid' | 'nova' | 'alien' | 'black hole';
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** Index within the level's list of that kind, from 0. */
  readonly index: number;
}

/** The list of a level that holds each kind of body. */
export const LIST_OF = { asteroid: 'asteroids', 'hot asteroid': 'asteroids', nova: 'novae', alien: 'aliens' } as const;

/** Asteroids, novae, aliens, then the black hole. */
export function bodiesOf(level: Level): Body[] {
  const bodies: Body[] = [];
  const add = (
    kind: Body['kind'],
    index: number,
    o: { readonly x: number; readonly y: number; readonly radius: number },
  ): void => {
    bodies.push({ kind, x: o.x, y: o.y, radius: o.radius, index });
  };
  for (const [i, o] of level.asteroids.entries()) add(o.hot ? 'hot asteroid' : 'asteroid', i, o);
  for (const [i, o] of level.novae.entries()) add('nova', i, o);
  for (const [i, o] of level.aliens.entries()) add('alien', i, o);
  add('black hole', 0, level.blackHole);
  return bodies;
}

/** The JSON pointer of a body in the level file. */
export const pointerOf = ({ kind, index }: Body): string => (kind === 'black hole' ? '/blackHole' : `/${LIST_OF[kind]}/${index}`);

/** The name of a body in a sentence: `nova 3`, `the black hole`. */
export function nameOf({ kind, index }: Body): string {
  if (kind === 'black hole') return 'the black hole';
  return kind === 'hot asteroid' ? objectName('asteroid', index, { hot: true }) : objectName(kind, index);
}

/** Whether touching it ends a run with `collided`. */
export const isHazard = ({ kind }: Body): boolean => kind === 'nova' || kind === 'hot asteroid' || kind === 'alien';

/** Whether it stays where the level places it during a whole run. */
export const staysPut = ({ kind }: Body, recoil: boolean): boolean => kind === 'nova' || (kind === 'hot asteroid' && !recoil);
