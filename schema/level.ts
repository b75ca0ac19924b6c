import * as z from 'zod';

/** The version of the level format that this toolkit writes. */
export const LEVEL_VERSION = 1;

/** Radii in px that a level may leave out. */
export const DEFAULT_RADIUS = { blackHole: 18, alien: 25, mineral: 7 } as const;

/** Farther than this from every asteroid she is lost, in px, when a level doesn't say. */
export const DEFAULT_RANGE = 250;

/** What numbers and lists of a level may be at most, and radii at least. */
export const LIMITS = {
  /** px, either sign */
  coordinate: 1e9,
  /** px */
  radius: 1e6,
  /** px, radii and the range: recoil goes with 1 / diameter, and what is smaller could only be hit by rounding */
  leastRadius: 1e-3,
  /** px/s per axis, either sign: the game's own speed limit */
  velocity: 1000,
  /** ticks of 1/60 s: an hour */
  tick: 216_000,
  /** objects in one list */
  objects: 20_000,
  runs: 1000,
  /** holds in one run */
  holds: 20_000,
} as const;

const x = z.number().min(-LIMITS.coordinate).max(LIMITS.coordinate).describe('Place in px, from left to right.');
const y = z.number().min(-LIMITS.coordinate).max(LIMITS.coordinate).describe('Place in px, from top to bottom.');
const velocity = z.number().min(-LIMITS.velocity).max(LIMITS.velocity);
const radius = z.number().min(LIMITS.leastRadius).max(LIMITS.radius);

const id = z
  .string()
  .regex(/^[a-z0-9]{2,16}$/)
  .optional()
  .describe(
    'Short random name of this object: it stays while the object is moved and edited. Unique in the level; `gq fmt` adds missing ones.',
  );

const at = { id, x, y };

const astronaut = z
  .strictObject({
    x,
    y,
    vx: velocity.optional().describe('Speed to the right at the start, px/s; 0 when left out.'),
    vy: velocity.optional().describe('Speed downwards at the start, px/s; 0 when left out.'),
  })
  .describe('Where she starts: the centre of a box of 20 x 32 px.');

const blackHole = z
  .strictObject({
    x,
    y,
    radius: radius.optional().describe(`Radius in px; ${DEFAULT_RADIUS.blackHole} when left out.`),
  })
  .describe('Touching it completes the level.');

const asteroid = z
  .strictObject({
    ...at,
    radius: radius.describe('Radius in px; the original uses 16 and 32.'),
    hot: z.boolean().optional().describe('A hot asteroid pulls like a cold one, and kills on touch; false when left out.'),
  })
  .describe('Pulls her while it is the nearest asteroid and the gun is held.');

const nova = z
  .strictObject({ ...at, radius: radius.describe('Radius in px; the original uses 16 and 32.') })
  .describe('A dwarf nova kills on touch; the gun never targets it.');

const repulsor = z
  .strictObject({ ...at, radius: radius.describe('Radius in px; the original uses 32 and 48.') })
  .describe(
    'A field that pushes her away from its centre at 20 px/s2 while her centre is inside; where fields overlap, the first one.',
  );

const alien = z
  .strictObject({ ...at, radius: radius.optional().describe(`Radius in px; ${DEFAULT_RADIUS.alien} when left out.`) })
  .describe(
    'Sleeps until her centre is nearer than 150 px, then accelerates towards her. Kills on touch; two that touch explode.',
  );

const mineral = z
  .strictObject({ ...at, radius: radius.optional().describe(`Radius in px; ${DEFAULT_RADIUS.mineral} when left out.`) })
  .describe('Collected on touch; not needed to complete the level.');

const tick = z.int().min(0).max(LIMITS.tick);

/** [press, release): the gun is held from tick `press` up to, not including, tick `release` (1/60 s each). */
const hold = z
  .tuple([tick, tick])
  .describe('[press, release): ticks of 1/60 s; the gun is held from press up to, not including, release.');

const run = z
  .strictObject({
    name: z.string().min(1).max(80).describe('Unique in the level.'),
    holds: z.array(hold).max(LIMITS.holds).describe('When the gun is held.'),
  })
  .describe('What a player does: proof that the level can be completed, or that it fails as it should.');

/** One level, as a file says it. Lists that are left out are empty. */
export const levelSchema = z
  .strictObject({
    $schema: z.string().optional().describe('Where the JSON Schema of this format is, for editors.'),
    version: z.literal(LEVEL_VERSION).describe('Version of this format.'),
    name: z.string().min(1).max(120).describe('What players and reports call the level.'),
    description: z.string().max(2000).optional().describe('What the level teaches or asks for.'),
    astronaut,
    blackHole,
    range: radius
      .optional()
      .describe(`Farther than this from the centre of every asteroid she is lost, px; ${DEFAULT_RANGE} when left out.`),
    recoil: z.boolean().optional().describe('Whether the target of the gun is pulled towards her, too; false when left out.'),
    asteroids: z.array(asteroid).max(LIMITS.objects).optional().describe('What the gun can target.'),
    novae: z.array(nova).max(LIMITS.objects).optional().describe('Kill on touch; never a target.'),
    repulsors: z.array(repulsor).max(LIMITS.objects).optional().describe('Fields that push her away.'),
    aliens: z.array(alien).max(LIMITS.objects).optional().describe('Chase her when she comes near.'),
    minerals: z.array(mineral).max(LIMITS.objects).optional().describe('To collect on the way; usually three.'),
    runs: z.array(run).max(LIMITS.runs).optional().describe('Scripted runs; the first is the one that is shown.'),
  })
  .describe('A level of Gravity Quest. Keys that begin with x- are yours: they are kept and not checked.');

/** The lists of objects in a level, in the order of a file. */
export const OBJECT_LISTS = ['asteroids', 'novae', 'repulsors', 'aliens', 'minerals'] as const;

/** A level as its file says it: what may be left out may be missing. */
export type LevelFile = z.infer<typeof levelSchema>;

/** A place in a level, px. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A disc in a level; `radius` in px. */
export interface Disc extends Place {
  readonly radius: number;
}

/** An object of a level that is a disc. */
export interface Circle extends Disc {
  /** null: the file gives it none */
  readonly id: string | null;
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
  readonly astronaut: Place & { readonly vx: number; readonly vy: number };
  readonly blackHole: Disc;
  readonly range: number;
  readonly recoil: boolean;
  readonly asteroids: readonly Asteroid[];
  readonly novae: readonly Circle[];
  readonly repulsors: readonly Circle[];
  readonly aliens: readonly Circle[];
  readonly minerals: readonly Circle[];
  readonly runs: readonly ScriptedRun[];
}
