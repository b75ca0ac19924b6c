import type { DifficultyReport, RunFoundReport } from '../../schema/index.ts';
import type { Candidate } from '../../solver/index.ts';
import { problemJson, robustnessJson } from '../report-parts/index.ts';
import type { MeasuredLevel } from './measured-level.ts';
import type { PackCurve } from './pack-curve.ts';
import { forecastJson, playersJson, playsJson } from './players-json.ts';
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
