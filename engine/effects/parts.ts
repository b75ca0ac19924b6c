import type { ObjectList } from '../../schema/basics/index.ts';
import { INDEXING } from '../box-index.ts';
import type { Indexing } from '../indexed-circles.ts';
import { alienChase, alienExplosion } from './aliens/index.ts';
import { blackHole } from './black-hole/index.ts';
import type { Effect } from './effect.ts';
import { gun, recoil as recoilEffect } from './gun/index.ts';
import { hotAsteroids, novae } from './hazards/index.ts';
import { minerals as mineralEffect } from './minerals/index.ts';
import { range } from './range/index.ts';
import { repulsor } from './repulsor/index.ts';
import { speedLimit } from './speed-limit/index.ts';
import { winds as windEffect } from './winds/index.ts';
import { wormholes as wormholeEffect } from './wormholes/index.ts';

/** A part of the game that a program includes if its levels call for it. */
export interface GamePart {
  /** The name under which it is imported. */
  readonly name: string;
  /** The lists of a level that call for it. */
  readonly lists: readonly ObjectList[];
  /** The effects that it includes. */
  readonly effects: readonly Effect[];
  /** What finds objects where there are many. */
  readonly indexing?: Indexing;
}

/** What every level calls for: the gun, hazards that stand still, minerals, the black hole, the range and the speed limit. */
export const BASE: readonly Effect[] = [gun, speedLimit, novae, hotAsteroids, mineralEffect, blackHole, range];

/** The lists that the effects of {@link BASE} play. */
export const LISTS_OF_BASE: readonly ObjectList[] = ['asteroids', 'novae', 'minerals'];

/** Levels with aliens. */
export const aliens: GamePart = { name: 'aliens', lists: ['aliens'], effects: [alienChase, alienExplosion] };

/** Levels with repulsors. */
export const repulsors: GamePart = { name: 'repulsors', lists: ['repulsors'], effects: [repulsor] };

/** Levels in which the gun pulls its target towards her. */
export const recoil: GamePart = { name: 'recoil', lists: [], effects: [recoilEffect] };

/** Levels with winds. */
export const winds: GamePart = { name: 'winds', lists: ['winds'], effects: [windEffect] };

/** Levels with wormholes. */
export const wormholes: GamePart = { name: 'wormholes', lists: ['wormholes'], effects: [wormholeEffect] };

/** Levels with 128 objects of a kind or more. */
export const manyObjects: GamePart = { name: 'manyObjects', lists: [], effects: [], indexing: INDEXING };
