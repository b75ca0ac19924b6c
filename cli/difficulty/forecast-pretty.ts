import type { FittedPlayers } from '../../check/plays/index.ts';
import { plural } from '../../check/words/index.ts';
import type { FitInterval, PlayerForecast } from '../../solver/index.ts';
import { percent } from '../report-parts/index.ts';

/** The attempts whose pass rates are named after the first. */
const LATER = [5, 10];

/** What a model of players expects, for people: lines with a label and a value. */
export function forecastLines({ players, attempts, half, most }: PlayerForecast): [label: string, text: string][] {
  const [first] = attempts;
  const later = LATER.flatMap((number) => {
    const row = attempts[number - 1];
    return row === undefined ? [] : `${percent(row.pass.p)} at attempt ${number}`;
  });
  const { p, low, high } = first.pass;
  const rates = [`${percent(p)} pass at the first attempt (${percent(low)} to ${percent(high)})`, ...later].join(', ');
  return [
    ['model', `of ${plural(players, 'synthetic player')}: ${rates}`],
    ['', `nine in ten players have a chance of ${percent(first.range[0])} to ${percent(first.range[1])} at the first attempt`],
    ['', solvedInWords(half, most, attempts.length)],
  ];
}

function solvedInWords(half: number | null, most: number | null, all: number): string {
  if (half === null) return `fewer than half have passed after ${all} attempts`;
  const nine = most === null ? `fewer than nine in ten after ${all}` : `nine in ten within ${most}`;
  return `half of them have passed within ${plural(half, 'attempt')}, ${nine}`;
}

/** The player model fitted to plays, for people. */
export function fitLines({ fit, forecast }: FittedPlayers): [label: string, text: string][] {
  const { players, edges, scale, learning, spread } = fit;
  const { firstErrorMs, lastErrorMs, attempts } = forecast;
  const error = `off by ${firstErrorMs.toFixed(0)} ms at first, ${lastErrorMs.toFixed(0)} ms after ${attempts.length - 1} attempts of practice`;
  const own = spread === null ? '' : `; players differ by a factor of ${between(spread, Math.exp)}`;
  return [
    ['fit', `the model fits with ${between(scale)} times its noise: ${error}`],
    ['', `learning exponent ${between(learning)}${own}`],
    ['', `from ${plural(edges, 'press or release', 'presses and releases')} of ${plural(players, 'player')}; 90 % intervals`],
    ...forecastLines(forecast).map(([, text], i): [string, string] => [i === 0 ? 'so fitted' : '', text]),
  ];
}

function between({ value, low, high }: FitInterval, map: (x: number) => number = (x) => x): string {
  const [v, l, h] = [value, low, high].map((x) => map(x).toFixed(2));
  return `${v} (${l} to ${h})`;
}
