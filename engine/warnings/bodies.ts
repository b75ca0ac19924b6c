import type { Level } from '../../schema/index.ts';

/** A solid circle of a level: something she sees, and may touch. Lengths in px. */
export interface Body {
  readonly kind: 'asteroid' | 'hot asteroid' | 'nova' | 'alien' | 'black hole';
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** JSON pointer of the object in the level file. */
  readonly pointer: string;
  /** What to call it in a sentence: `nova novae[2]`. */
  readonly name: string;
}

const LISTS = { asteroid: 'asteroids', 'hot asteroid': 'asteroids', nova: 'novae', alien: 'aliens' } as const;

function body(kind: keyof typeof LISTS, index: number, { x, y, radius }: { x: number; y: number; radius: number }): Body {
  const list = LISTS[kind];
  return { kind, x, y, radius, pointer: `/${list}/${index}`, name: `${kind} ${list}[${index}]` };
}

/** Asteroids, novae, aliens, then the black hole. */
export function bodiesOf(level: Level): Body[] {
  const { x, y, radius } = level.blackHole;
  return [
    ...level.asteroids.map((o, i) => body(o.hot ? 'hot asteroid' : 'asteroid', i, o)),
    ...level.novae.map((o, i) => body('nova', i, o)),
    ...level.aliens.map((o, i) => body('alien', i, o)),
    { kind: 'black hole', x, y, radius, pointer: '/blackHole', name: 'black hole' },
  ];
}

/** Whether touching it ends the run badly. */
export const isHazard = ({ kind }: Body): boolean => kind === 'nova' || kind === 'hot asteroid' || kind === 'alien';

/** Whether it is where the level puts it for as long as a run lasts. */
export const staysPut = ({ kind }: Body, recoil: boolean): boolean => kind === 'nova' || (kind === 'hot asteroid' && !recoil);
