import { type Asteroid, type Circle, type Level, NO_OBJECTS, type OwnRules } from '../../schema/index.ts';

type Place = Pick<Circle, 'x' | 'y' | 'radius'>;

/** The lists of a level as tests write them: without ids, and cold by default. */
export interface PlainLevel {
  astronaut?: Partial<Level['astronaut']>;
  blackHole?: Partial<Level['blackHole']>;
  range?: number;
  recoil?: boolean;
  asteroids?: readonly (Place & { hot?: boolean })[];
  novae?: readonly Place[];
  repulsors?: readonly Place[];
  aliens?: readonly Place[];
  minerals?: readonly Place[];
  winds?: readonly (Place & { ax?: number; ay?: number })[];
  wormholes?: readonly (Place & { toX: number; toY: number })[];
  rules?: OwnRules;
}

const named = (list: readonly Place[] | undefined): Circle[] => (list ?? []).map((o) => ({ id: null, ...o }));

/** A level with only the objects of a test: she rests at 0, 0; the black hole and an asteroid (never in range) are far away. */
export function plainLevel(parts: PlainLevel = {}): Level {
  const asteroids = parts.asteroids ?? [{ x: 1e5, y: 1e5, radius: 16 }];
  return {
    name: 'test',
    description: '',
    astronaut: { x: 0, y: 0, vx: 0, vy: 0, ...parts.astronaut },
    blackHole: { x: -1e5, y: -1e5, radius: 18, ...parts.blackHole },
    range: parts.range ?? 1e6,
    recoil: parts.recoil ?? false,
    ...NO_OBJECTS,
    asteroids: asteroids.map((o): Asteroid => ({ id: null, hot: false, ...o })),
    novae: named(parts.novae),
    repulsors: named(parts.repulsors),
    aliens: named(parts.aliens),
    minerals: named(parts.minerals),
    winds: (parts.winds ?? []).map((o) => ({ id: null, ax: 0, ay: 0, ...o })),
    wormholes: (parts.wormholes ?? []).map((o) => ({ id: null, ...o })),
    ...(parts.rules === undefined ? {} : { rules: parts.rules }),
    runs: [],
  };
}
