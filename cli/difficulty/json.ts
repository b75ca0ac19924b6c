import type { FittedPlayers } from '../../check/plays/index.ts';
import type { DifficultyReport, FitReport, ForecastReport, RunFoundReport } from '../../schema/index.ts';
import type { Candidate, PlayerForecast } from '../../solver/index.ts';
import { problemJson, robustnessJson } from '../report-parts/index.ts';
import type { MeasuredLevel, PackCurve, Players } from './measured-level.ts';
import type { CollectedPlays } from './plays/index.ts';

/** The difficulty of levels as JSON. */
export function difficultyJson(
  levels: readonly MeasuredLevel[],
  plays: CollectedPlays | null,
  curves: readonly PackCurve[] = [],
): string {
  const packs = curves.map(({ file, name, levels: files, jumps }) => ({ file, name, levels: [...files], jumps: [...jumps] }));
  const own = { version: 1 as const, levels: levels.map(measuredJson), ...(packs.length > 0 && { packs }) };
  const report: DifficultyReport = plays === null ? own : { ...own, plays: playsJson(plays) };
  return `${JSON.stringify(report)}\n`;
}

/** The difficulty of a level as JSON. */
export function measuredJson(level: MeasuredLevel): DifficultyReport['levels'][number] {
  const { file, name, terms, runName, difficulty, comparedNames, curve, why, problems, players } = level;
  const shared = { file, name, terms, problems: problems.map(problemJson) };
  const played = players === null ? {} : { players: playersJson(players) };
  if (difficulty === null) return { ...shared, measured: null, why, ...played };
  const { run, comparison, robustness, sigmaAtHalf, mineralsExtra, shortcuts, grade, randomPlay, forecast } = difficulty;
  const { withoutPressing, onePress, withoutAsteroid } = shortcuts;
  return {
    ...shared,
    measured: {
      run: { name: runName, ...runJson(run) },
      grade: { ...grade },
      comparison: {
        runs: comparison.runs.map((own, i) => ({
          name: comparedNames[i],
          ...runJson(own.run),
          p40: own.p40,
          sigmaAtHalf: own.sigmaAtHalf,
          grade: own.grade,
        })),
        meanP40: comparison.meanP40,
        meanGrade: comparison.meanGrade,
      },
      robustness: robustnessJson(robustness),
      sigmaAtHalf: { ...sigmaAtHalf },
      smallestWindow: difficulty.smallestWindow,
      presses: difficulty.presses,
      length: difficulty.length,
      randomPlay: { ...randomPlay },
      mineralsExtra: mineralsExtra === null ? null : { ...mineralsExtra, run: runJson(mineralsExtra.run) },
      shortcuts: {
        withoutPressing: withoutPressing === null ? null : runJson(withoutPressing),
        onePress: { ...onePress, example: onePress.example === null ? null : runJson(onePress.example) },
        withoutAsteroid: withoutAsteroid.map(({ asteroid, use, run: way }) => ({
          asteroid,
          use,
          run: way === null ? null : runJson(way),
        })),
      },
      forecast: forecast === null ? null : forecastJson(forecast),
      curve: curve.map((success) => ({ ...success })),
    },
    why: null,
    ...played,
  };
}

const runJson = ({ holds, time, tick, minerals }: Candidate): RunFoundReport => ({
  holds: holds.map(([press, release]) => [press, release]),
  time,
  tick,
  minerals: [...minerals],
});

/** What players teach about a level, as JSON. */
function playersJson({ statistics, model, names, fit }: Players): DifficultyReport['levels'][number]['players'] {
  const { attempts, successes, share, low, high, players, playersWhoSucceed, minerals, byAttempt, reference } = statistics;
  return {
    ...{ attempts, successes, share, low, high, players, playersWhoSucceed },
    minerals: [...minerals],
    refused: statistics.refused.map(({ play, verdict, message }) => ({ play: names[play], verdict, message })),
    causes: statistics.causes.map((cause) => ({ ...cause })),
    clusters: statistics.clusters.map(({ plays, ...cluster }) => cluster),
    failures: statistics.all.flatMap(({ play, cause, x, y, tick, time }) =>
      cause === null ? [] : [{ play: names[play], cause, x, y, tick, time }],
    ),
    failureTimes: [...statistics.failureTimes],
    byAttempt: byAttempt.map((row) => ({ ...row })),
    routes: statistics.routes.map((route) => ({ ...route, asteroids: [...route.asteroids], play: names[route.play] })),
    reference:
      reference === null
        ? null
        : { name: reference.name, holds: reference.holds.map(([press, release]): [number, number] => [press, release]) },
    edges: statistics.edges.map((edge, i) => {
      const expectation = model?.edges[i];
      if (expectation === undefined) return { ...edge, expected: null, players: null };
      const { players: differ, ...expected } = expectation;
      return { ...edge, expected, players: differ };
    }),
    noise: model === null ? null : { ...model.noise },
    fit: fit === null ? null : fitJson(fit),
  };
}

/** What a model of players expects, as JSON. */
const forecastJson = (forecast: PlayerForecast): ForecastReport => ({
  ...forecast,
  parameters: { ...forecast.parameters },
  attempts: forecast.attempts.map((row) => ({ ...row, pass: { ...row.pass }, range: [...row.range], solved: { ...row.solved } })),
});

const fitJson = ({ fit, forecast }: FittedPlayers): FitReport => ({
  players: fit.players,
  attempts: fit.attempts,
  edges: fit.edges,
  scale: { ...fit.scale },
  learning: { ...fit.learning },
  spread: fit.spread === null ? null : { ...fit.spread },
  forecast: forecastJson(forecast),
});

/** What was read with --plays, as JSON. */
const playsJson = ({ found, refused, elsewhere, ignored }: CollectedPlays): DifficultyReport['plays'] => ({
  found,
  refused: refused.map(({ name, verdict, message }) => ({ play: name, verdict, message })),
  elsewhere: elsewhere.map(({ hash, count }) => ({ level: hash, count })),
  ignoredFiles: ignored,
});
