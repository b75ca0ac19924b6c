import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { createPlayers, type PlayerForecast, UNCALIBRATED } from '../../solver/index.ts';
import { ANY } from './levels.ts';
import { Share } from './statistics.ts';

/** Which of the intervals that `gq difficulty` reports contain the truth. */
export interface Coverage {
  /** Intervals of pass rates at attempts 1, 2, 5 and 10. */
  readonly pass: Share;
  /** Of those, the ones of rates from 2 % to 98 %: beyond, nearly every interval contains the truth. */
  readonly passInside: Share;
  /** Ranges in which nine in ten players are said to be: fresh players' own pass rates at attempts 1, 2 and 5, likewise inside. */
  readonly range: Share;
}

/** Ticks of a forecast. */
const REPORTED = 2_000_000;

/** Ticks of the simulation that stands for the truth: its error is a fifth of that of a forecast. */
const TRUTH = 50_000_000;

/** Forecasts with different seeds, each compared with the same truth. */
const FORECASTS = 4;

/** Fresh players whose own pass rates are measured, and the ticks for each. */
const FRESH = 20;
const FRESH_TICKS = 4_000_000;

const NUMBERS = [1, 2, 5, 10];

const isInside = (p: number): boolean => p >= 0.02 && p <= 0.98;

function forecast(scene: Scene, holds: readonly Hold[], seed: number, ticks: number, parameters = UNCALIBRATED): PlayerForecast {
  const players = createPlayers(scene, holds, ANY, { seed, parameters });
  players.advance(ticks);
  return players.forecast();
}

/**
 * Compares forecasts with what many fresh players do.
 * @param seed of the forecasts; another one for each level, so that their luck differs
 * @param random draws numbers from a standard normal distribution
 */
export function measureCoverage(scene: Scene, holds: readonly Hold[], seed: number, random: () => number): Coverage {
  const coverage: Coverage = { pass: new Share(), passInside: new Share(), range: new Share() };
  const truth = forecast(scene, holds, seed + 500, TRUTH);
  const reported = Array.from({ length: FORECASTS }, (_, i) => forecast(scene, holds, seed + i, REPORTED));
  for (const { attempts } of reported) {
    for (const number of NUMBERS) {
      const { p } = truth.attempts[number - 1].pass;
      const { low, high } = attempts[number - 1].pass;
      coverage.pass.add(low <= p && p <= high);
      if (isInside(p)) coverage.passInside.add(low <= p && p <= high);
    }
  }
  for (let player = 0; player < FRESH; player++) {
    const scale = Math.exp(UNCALIBRATED.spread * random());
    const own = forecast(scene, holds, seed + 600 + player, FRESH_TICKS, { ...UNCALIBRATED, scale, spread: 0 });
    for (const number of [1, 2, 5]) {
      if (!isInside(truth.attempts[number - 1].pass.p)) continue;
      const { p } = own.attempts[number - 1].pass;
      const [low, high] = reported[player % FORECASTS].attempts[number - 1].range;
      coverage.range.add(low <= p && p <= high);
    }
  }
  return coverage;
}
