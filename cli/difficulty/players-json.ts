import type { FittedPlayers } from '../../check/plays/index.ts';
import type { DifficultyReport, FitReport, ForecastReport } from '../../schema/index.ts';
import type { PlayerForecast } from '../../solver/index.ts';
import type { Players } from './measured-level.ts';
import type { CollectedPlays } from './plays/index.ts';

/** What players teach about a level, as JSON. */
export function playersJson({ statistics, model, names, fit }: Players): DifficultyReport['levels'][number]['players'] {
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
export const forecastJson = (forecast: PlayerForecast): ForecastReport => ({
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
export const playsJson = ({ found, refused, elsewhere, ignored }: CollectedPlays): DifficultyReport['plays'] => ({
  found,
  refused: refused.map(({ name, verdict, message }) => ({ play: name, verdict, message })),
  elsewhere: elsewhere.map(({ hash, count }) => ({ level: hash, count })),
  ignoredFiles: ignored,
});
