import {
  type EdgeStatistics,
  type FailureCause,
  type FittedPlayers,
  isAttempt,
  type ModelComparison,
  type PlayStatistics,
  type Quartiles,
} from '../../check/plays/index.ts';
import { plural } from '../../check/words/index.ts';
import { objectName, touchedName } from '../../schema/index.ts';
import type { FitInterval, PlayerForecast } from '../../solver/index.ts';
import { alignColumns, percent } from '../report-parts/index.ts';
import { type Colors, visibleLine } from '../terminal/index.ts';
import type { MeasuredLevel, Players } from './measured-level.ts';
import type { CollectedPlays } from './plays/index.ts';

/** Lists in the report on one level end after so many entries. */
const MOST_CAUSES = 6;
const MOST_CLUSTERS = 5;
const MOST_SECONDS = 12;
const MOST_ATTEMPTS = 5;
const MOST_WAYS = 4;

/** What to call the cause of a failure. */
export function causeInWords({ kind, index }: FailureCause): string {
  if (index !== null) return touchedName(kind, index);
  return kind === 'minerals' ? 'too few minerals' : kind;
}

/** What players teach about one level, for people: lines with labels, and a table of presses and releases. */
export function playersDetail({ statistics, model, p40, fit, names }: Players, colors: Colors, width: number | null): string {
  const { attempts } = statistics;
  if (attempts === 0) return '';
  const lines: [string, string][] = [
    ...successLines(statistics, model, p40),
    ...(fit === null ? [] : fitLines(fit)),
    ...attemptLines(statistics),
    ...failureLines(statistics),
    ...wayLines(statistics, names),
  ];
  const text = lines.map(([label, line]) => `${label.padEnd(12)}${visibleLine(line)}\n`).join('');
  return `${text}\n${edgeTable(statistics, model, colors, width)}`;
}

function successLines(statistics: PlayStatistics, model: ModelComparison | null, p40: number | null): [string, string][] {
  const { attempts, successes, share, low, high, players, playersWhoSucceed, minerals } = statistics;
  const known = players === 0 ? '' : ` of ${plural(players, 'player')}`;
  const lines: [string, string][] = [
    ['players', `${plural(attempts, 'attempt')}${known}: ${successes} succeed, ${percent(share)} (${between(low, high)})`],
  ];
  if (players > 0) lines.push(['', `${playersWhoSucceed} of ${plural(players, 'player')} succeed at least once`]);
  const most = minerals.length - 1;
  if (most > 0) {
    const all = minerals.map((count, i) => `${count} with ${i}`).filter((_, i) => minerals[i] > 0);
    if (all.length > 0) lines.push(['', `minerals at the black hole, of ${most}: ${all.join(', ')}`]);
  }
  if (model !== null) lines.push(['noise', noiseInWords(model, statistics)]);
  if (p40 !== null) lines.push(['', `at 40 ms the model predicts ${percent(p40)}`]);
  return lines;
}

const between = (low: number, high: number): string => `${percent(low)} to ${percent(high)}`;

function noiseInWords({ noise: { ms, low, high, capped } }: ModelComparison, { share }: PlayStatistics): string {
  const [from, to] = [low.toFixed(0), high.toFixed(0)];
  if (capped) return `no timing noise up to ${ms.toFixed(0)} ms explains that: attempts fail for other reasons`;
  if (share === 1) return `timing noise of up to ${to} ms explains that`;
  return `timing noise of ${ms.toFixed(0)} ms explains that (${from} to ${to} ms)`;
}

function attemptLines({ byAttempt, players }: PlayStatistics): [string, string][] {
  if (players === 0) return [];
  const shown = byAttempt.slice(0, MOST_ATTEMPTS);
  const lines = shown.map(({ number, attempts, successes, share, low, high, first }): [string, string] => {
    const interval = attempts === 1 ? '' : ` (${between(low, high)})`;
    return [
      `attempt ${number}`,
      `${successes} of ${attempts} succeed, ${percent(share)}${interval}; ${first} for the first time`,
    ];
  });
  const later = byAttempt.slice(MOST_ATTEMPTS);
  if (later.length === 0) return lines;
  const sum = (figure: 'attempts' | 'successes' | 'first') => later.reduce((total, row) => total + row[figure], 0);
  const [attempts, successes, first] = [sum('attempts'), sum('successes'), sum('first')];
  const text = `${successes} of ${attempts} succeed, ${percent(successes / attempts)}; ${first} for the first time`;
  return [...lines, ['later', text]];
}

function failureLines({ causes, clusters, failureTimes }: PlayStatistics): [string, string][] {
  const lines: [string, string][] = [];
  if (causes.length > 0) {
    const shown = causes
      .slice(0, MOST_CAUSES)
      .map(({ cause, count, share }) => `${causeInWords(cause)} ${count} (${percent(share)})`);
    const rest = causes.slice(MOST_CAUSES).reduce((sum, { count }) => sum + count, 0);
    lines.push(['failures', [...shown, ...(rest > 0 ? [`others ${rest}`] : [])].join(', ')]);
  }
  for (const [i, { cause, count, share, x, y, spread }] of clusters.slice(0, MOST_CLUSTERS).entries()) {
    const place = `${x.toFixed(0)}, ${y.toFixed(0)}`;
    lines.push([
      `place ${i + 1}`,
      `${causeInWords(cause)} at ${place} (spread ${spread.toFixed(0)} px): ${count}, ${percent(share)} of the failures`,
    ]);
  }
  const seconds = failureTimes.flatMap((count, second) => (count > 0 ? [{ second, count }] : []));
  const most = [...seconds].sort((a, b) => b.count - a.count || a.second - b.second).slice(0, MOST_SECONDS);
  const shown = most.sort((a, b) => a.second - b.second).map(({ second, count }) => `${second}-${second + 1} s ${count}`);
  const rest = seconds.reduce((sum, { count }) => sum + count, 0) - most.reduce((sum, { count }) => sum + count, 0);
  if (shown.length > 0) lines.push(['when', [...shown, ...(rest > 0 ? [`others ${rest}`] : [])].join(', ')]);
  return lines;
}

function wayLines({ routes }: PlayStatistics, names: readonly string[]): [string, string][] {
  const lines = routes.slice(0, MOST_WAYS).map(({ asteroids, count, share, run, quickest, play }, i): [string, string] => {
    const way = asteroids.length === 0 ? 'no asteroid' : asteroids.map((asteroid) => objectName('asteroid', asteroid)).join(', ');
    const whose = run === null ? 'no run of the level goes this way' : `as run ${JSON.stringify(run)}`;
    const best = `the quickest ${quickest.toFixed(2)} s, ${names[play]}`;
    return [`way ${i + 1}`, `${way}: ${count}, ${percent(share)} of the successes; ${whose}; ${best}`];
  });
  const rest = routes.slice(MOST_WAYS).reduce((sum, { count }) => sum + count, 0);
  return rest > 0 ? [...lines, ['other ways', String(rest)]] : lines;
}

/** What to call the moment after which attempts fail. */
const edgeInWords = ({ type, hold }: EdgeStatistics): string => (type === 'start' ? 'the start' : `${type} ${hold + 1}`);

function edgeTable(
  { edges, reference }: PlayStatistics,
  model: ModelComparison | null,
  colors: Colors,
  width: number | null,
): string {
  if (reference === null || edges.length === 0) return '';
  const head = ['fail after', 'reached', 'fail', '', 'model', 'off if they succeed', 'off if they fail', ''];
  const rows = edges.map((edge, i) => {
    const expected = model?.edges[i];
    const differ = expected?.players ?? null;
    return [
      edgeInWords(edge),
      String(edge.reached),
      String(edge.failed),
      edge.reached === 0 ? '' : percent(edge.share),
      expected === undefined ? '' : percent(expected.share),
      offInWords(edge.succeeding),
      offInWords(edge.failing),
      differ === null ? '' : `${differ} often than the model`,
    ];
  });
  const [first, ...lines] = alignColumns(rows, { right: [1, 2, 3, 4, 5, 6], head, width });
  const painted = lines.map((line, i) => (model?.edges[i].players === 'more' ? colors.red(line) : line));
  const name = reference.name === null ? 'the run above' : `run ${JSON.stringify(reference.name)}`;
  const note = `off: ticks after ${visibleLine(name)}, the median and between which half of the attempts are\n`;
  return `${first === '' ? '' : `${colors.bold(first)}\n`}${painted.join('\n')}\n${note}\n`;
}

const signed = (ticks: number): string => (ticks > 0 ? `+${round(ticks)}` : round(ticks));

const round = (ticks: number): string => String(Math.round(10 * ticks) / 10);

const offInWords = (quartiles: Quartiles | null): string =>
  quartiles === null ? '' : `${signed(quartiles.median)} (${signed(quartiles.low)} to ${signed(quartiles.high)})`;

/** What players teach about several levels: a table. */
export function playersTable(levels: readonly MeasuredLevel[], colors: Colors, width: number | null): string {
  const played = levels.flatMap(({ file, players }) =>
    players === null || players.statistics.attempts === 0 ? [] : [{ file, ...players }],
  );
  if (played.length === 0) return '';
  const head = ['attempts', 'players', 'success', '', 'model at 40 ms', 'noise', 'fitted', 'most failures', 'level'];
  const sorted = played.sort((a, b) => b.statistics.share - a.statistics.share);
  const rows = sorted.map(({ file, statistics, model, p40, fit }) => {
    const { attempts, players, share, low, high, causes } = statistics;
    return [
      String(attempts),
      players === 0 ? '' : String(players),
      percent(share),
      between(low, high),
      p40 === null ? '' : percent(p40),
      model === null ? '' : `${model.noise.capped ? '> ' : ''}${model.noise.ms.toFixed(0)} ms`,
      fit === null ? '' : `${fit.fit.scale.value.toFixed(2)} x`,
      causes.length === 0 ? '' : `${causeInWords(causes[0].cause)}, ${percent(causes[0].share)}`,
      visibleLine(file),
    ];
  });
  const [first, ...lines] = alignColumns(rows, { right: [0, 1, 2, 3, 4, 5, 6], head, lead: 8, width });
  return `${first === '' ? '' : `${colors.bold(first)}\n`}${lines.join('\n')}\n\n`;
}

/** The plays of every level once: two files may be the same level. */
const playsOfLevels = ({ levels }: CollectedPlays) => [...new Set(levels.values())];

/** How many plays there are, and how many of them count. */
export function playsInWords(plays: CollectedPlays): string {
  const { found, refused, elsewhere, ignored } = plays;
  const replayed = playsOfLevels(plays).flatMap((level) => level.replayed);
  const counted = replayed.filter(isAttempt).length;
  const unusable = refused.length + replayed.length - counted;
  const others = elsewhere.reduce((total, { count }) => total + count, 0);
  const parts = [`${plural(found, 'play')}: ${counted} count`];
  if (unusable > 0)
    parts.push(
      `${unusable} ${unusable === 1 ? 'is' : 'are'} not what ${unusable === 1 ? 'it claims' : 'they claim'} or can't be read`,
    );
  if (others > 0) {
    const many = elsewhere.length > 1 ? ` (${elsewhere.length} of them)` : '';
    parts.push(`${others} ${others === 1 ? 'is' : 'are'} of other levels or versions${many}`);
  }
  const files = ignored === 0 ? '' : `; ${plural(ignored, 'other file')} ignored`;
  return `${parts.join(', ')}${files}\n`;
}

/** Names the plays that do not count, for standard error. */
export function refusedPlays(plays: CollectedPlays): string {
  const MOST = 10;
  const ofLevels = playsOfLevels(plays).flatMap(({ replayed, names }) =>
    replayed.flatMap((play) => (isAttempt(play) ? [] : [{ ...play, name: names[play.play] }])),
  );
  const all = [...plays.refused, ...ofLevels];
  const lines = all
    .slice(0, MOST)
    .map(({ name, verdict, message }) => `${visibleLine(name)}: ${verdict}: ${visibleLine(message)}\n`);
  const rest = all.length - MOST;
  return (
    lines.join('') +
    (rest > 0 ? `and ${plural(rest, 'further play')} that do${rest === 1 ? 'es' : ''} not count: --format json names all\n` : '')
  );
}

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
function fitLines({ fit, forecast }: FittedPlayers): [label: string, text: string][] {
  const { players, edges, scale, learning, spread } = fit;
  const { firstErrorMs, lastErrorMs, attempts } = forecast;
  const error = `off by ${firstErrorMs.toFixed(0)} ms at first, ${lastErrorMs.toFixed(0)} ms after ${attempts.length - 1} attempts of practice`;
  const own = spread === null ? '' : `; players differ by a factor of ${within(spread, Math.exp)}`;
  return [
    ['fit', `the model fits with ${within(scale)} times its noise: ${error}`],
    ['', `learning exponent ${within(learning)}${own}`],
    ['', `from ${plural(edges, 'press or release', 'presses and releases')} of ${plural(players, 'player')}; 90 % intervals`],
    ...forecastLines(forecast).map(([, text], i): [string, string] => [i === 0 ? 'so fitted' : '', text]),
  ];
}

function within({ value, low, high }: FitInterval, map: (x: number) => number = (x) => x): string {
  const [v, l, h] = [value, low, high].map((x) => map(x).toFixed(2));
  return `${v} (${l} to ${h})`;
}
