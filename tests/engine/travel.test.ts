import { describe, expect, it } from 'vitest';
import { ContinuousSimulation, WHOLE_METHOD } from '../../engine/continuous/index.ts';
import { chaserTravel, ownTravel, rockTravel } from '../../engine/events/index.ts';
import {
  ACCURACIES,
  type Accuracy,
  accuracyOf,
  compile,
  joinHolds,
  playScript,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import { ALERTNESS, chaserPlaceAt, type Motion, placeAt, RECORDS, rockAt, SLOTS } from '../../engine/motion/index.ts';
import { expectDeep } from '../depth.ts';
import { propertySettings } from '../property-settings.ts';
import { degenerateScene } from '../scenes/degenerate-scene.ts';
import { type RandomScene, randomScene } from '../scenes/random-scene.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { continuousNames } from './accuracies.ts';

const { LENGTH_H } = SLOTS;
const { CHASER } = RECORDS;
const { GONE } = ALERTNESS;
const SAMPLES = 16;
const SCENES = Math.ceil(16 * propertySettings(process.env).runs);
/** Seeds of scenes in which the rock that she drags is faster than its record says. */
const FORMERLY_BEYOND = [106, 115];

type State = Float64Array;
const apart = (a: State, b: State): number => Math.hypot(b[0] - a[0], b[1] - a[1]);

const SETTINGS: readonly Accuracy[] = [
  ...continuousNames.map((name) => ACCURACIES[name]),
  accuracyOf({ integrator: 'euler', rate: 60, tolerance: null, contact: 'swept' }),
  accuracyOf({ integrator: 'rk4', rate: 15, tolerance: null, contact: 'swept' }),
];

/** By how much something is farther from where a piece begins than its bound says, px, at most over a run; and how near it comes to that. */
function farthest(scene: RandomScene, accuracy: Accuracy): { beyond: number; share: number } {
  let beyond = Number.NEGATIVE_INFINITY;
  let share = 0;
  const see = (far: number, most: number) => {
    beyond = Math.max(beyond, far - most);
    if (most > 1e-3) share = Math.max(share, far / most);
  };
  const piece = (m: Motion, t: number) => {
    const length = Math.min(t, m.s[LENGTH_H]);
    if (!(length > 0)) return;
    const times = Array.from({ length: SAMPLES }, (_, k) => ((k + 1) / SAMPLES) * length);
    const { recoil } = m;
    const hers = (time: number): State => {
      placeAt(m, time);
      return m.her.map((own, k) => own + (recoil ? m.base[k] : 0));
    };
    const from = hers(0);
    for (const time of times) see(apart(from, hers(time)), ownTravel(m, Math.hypot(from[2], from[3]), time));
    const out = new Float64Array(4);
    const follow = (at: (time: number) => void, travel: (time: number) => number) => {
      at(0);
      const start = out.slice();
      for (const time of times) {
        at(time);
        see(apart(start, out), travel(time));
      }
    };
    for (let i = 0; recoil && i < m.scene.targets.count; i++) {
      follow(
        (time) => rockAt(m, i, time, out),
        (time) => rockTravel(m, i, time),
      );
    }
    for (let i = 0; i < m.scene.aliens.count; i++) {
      if (m.s[m.chasers + CHASER * i + 4] === GONE) continue;
      follow(
        (time) => chaserPlaceAt(m, i, time, out),
        (time) => chaserTravel(m, i, m.rules.alienPull, time),
      );
    }
  };
  const budget = new WorkBudget(2000);
  const simulation = new ContinuousSimulation(
    WHOLE_METHOD,
    compile(scene.level, accuracy),
    { keeps: true, piece, event: () => {} },
    budget,
  );
  try {
    playScript(simulation, joinHolds(scene.holds), Math.min(3600, scene.maxTime * 60));
  } catch (error) {
    // enough was seen of a run that costs too much
    if (!(error instanceof WorkLimitReached)) throw error;
  }
  return { beyond, share };
}

describe.each(SETTINGS.map((accuracy) => [accuracy.name, accuracy] as const))('at %s', (_, accuracy) => {
  it.each([
    ['random scenes', randomScene],
    ['scenes in which a digit decides', degenerateScene],
    ['windy scenes', windyScene],
  ] as const)('no piece takes her, a rock or an alien farther than is said, in %s', (_name, make) => {
    let beyond = Number.NEGATIVE_INFINITY;
    let share = 0;
    for (const seed of [...Array(SCENES).keys(), ...FORMERLY_BEYOND]) {
      const found = farthest(make(seed), accuracy);
      beyond = Math.max(beyond, found.beyond);
      share = Math.max(share, found.share);
    }
    // the neighbour list has 1e-6 px of room
    expect(beyond).toBeLessThan(1e-8);
    // a bound that is never approached would hide a mistake
    expectDeep(share).toBeGreaterThan(0.99);
  });
});
