import * as z from 'zod';

/** The version of the level format that this toolkit writes. */
export const LEVEL_VERSION = 1;

/** Radii in px that a level may leave out. */
export const DEFAULT_RADIUS = { blackHole: 18, alien: 25, mineral: 7 } as const;

/** Farther than this from every asteroid she is lost, in px, when a level doesn't say. */
export const DEFAULT_RANGE = 250;

const coordinate = z.number().min(-1e9).max(1e9);
const radius = z.number().positive().max(1e6);
const velocity = z.number().min(-1000).max(1000);

const id = z
  .string()
  .regex(/^[a-z0-9]{2,16}$/)
  .optional()
  .describe('Short random name of this object, stable while it is moved and edited; unique in the level.');

const at = {
  id,
  x: coordinate.describe('px, grows to the right'),
  y: coordinate.describe('px, grows downwards'),
};

const astronaut = z
  .strictObject({
    x: at.x,
    y: at.y,
    vx: velocity.optional().describe('px/s at the start; 0 when left out'),
    vy: velocity.optional().describe('px/s at the start; 0 when left out'),
  })
  .describe('Where she starts: the centre of a box of 20 x 32 px.');

const blackHole = z
  .strictObject({
    x: at.x,
    y: at.y,
    radius: radius.optional().describe(`px; ${DEFAULT_RADIUS.blackHole} when left out`),
  })
  .describe('Touching it completes the level.');

const asteroid = z.strictObject({
  ...at,
  radius: radius.describe('px; the original uses 16 and 32'),
  hot: z.boolean().optional().describe('A hot asteroid pulls like a cold one, and burns on touch.'),
});

const nova = z.strictObject({ ...at, radius: radius.describe('px; burns on touch, the gun never targets it') });

const repulsor = z.strictObject({
  ...at,
  radius: radius.describe('px; pushes her away at 20 px/s2 while her centre is inside'),
});

const alien = z.strictObject({
  ...at,
  radius: radius.optional().describe(`px; ${DEFAULT_RADIUS.alien} when left out`),
});

const mineral = z.strictObject({
  ...at,
  radius: radius.optional().describe(`px; ${DEFAULT_RADIUS.mineral} when left out`),
});

const tick = z.int().min(0).max(216_000);

/** [press, release): the gun is held from tick `press` up to, not including, tick `release` (1/60 s each). */
const hold = z
  .tuple([tick, tick])
  .describe('[press, release): ticks of 1/60 s; the gun is held from press up to, not including, release');

const run = z.strictObject({
  name: z.string().min(1).max(80),
  holds: z.array(hold).max(20_000),
});

/** One level, as a file says it. Lists that are left out are empty. */
export const levelSchema = z
  .strictObject({
    $schema: z.string().optional(),
    version: z.literal(LEVEL_VERSION),
    name: z.string().min(1).max(120),
    description: z.string().max(2000).optional().describe('What the level teaches or asks for.'),
    astronaut,
    blackHole,
    range: radius.optional().describe(`px; ${DEFAULT_RANGE} when left out. Farther than this from every asteroid she is lost.`),
    recoil: z.boolean().optional().describe('Whether the target of the gun is pulled towards her too; false when left out.'),
    asteroids: z.array(asteroid).optional(),
    novae: z.array(nova).optional(),
    repulsors: z.array(repulsor).optional(),
    aliens: z.array(alien).optional(),
    minerals: z.array(mineral).optional(),
    runs: z.array(run).optional(),
  })
  .describe('A level of Gravity Quest.');

/** A level as its file says it: what may be left out may be missing. */
export type LevelFile = z.infer<typeof levelSchema>;

export interface Circle {
  readonly id: string | null;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

export interface Asteroid extends Circle {
  readonly hot: boolean;
}

/** A half-open interval of ticks (1/60 s) in which the gun is held. */
export type Hold = readonly [press: number, release: number];

export interface ScriptedRun {
  readonly name: string;
  readonly holds: readonly Hold[];
}

/** A valid level with every default filled in; lengths in px, speeds in px/s. */
export interface Level {
  readonly name: string;
  readonly description: string;
  readonly astronaut: { readonly x: number; readonly y: number; readonly vx: number; readonly vy: number };
  readonly blackHole: { readonly x: number; readonly y: number; readonly radius: number };
  readonly range: number;
  readonly recoil: boolean;
  readonly asteroids: readonly Asteroid[];
  readonly novae: readonly Circle[];
  readonly repulsors: readonly Circle[];
  readonly aliens: readonly Circle[];
  readonly minerals: readonly Circle[];
  readonly runs: readonly ScriptedRun[];
}
