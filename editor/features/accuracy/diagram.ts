import { type AccuracyName, isAccuracyName } from '../../../engine/index.ts';
import { METHODS } from '../../../engine/work-precision/index.ts';
import { drawDiagram, type Ground, linesOf, noteOf } from '../../../picture/accuracy/index.ts';
import type { Setting } from '../../workers/index.ts';

interface DiagramOf {
  readonly level: string;
  readonly run: string | null;
  readonly settings: readonly Setting[];
  /** The setting in use, which is ringed. */
  readonly current: AccuracyName;
}

/** The work-precision diagram of a run as an SVG document. */
export function drawSettings({ level, run, settings, current }: DiagramOf, ground: Ground): string {
  const measured = settings.flatMap((setting) => {
    const accuracy = METHODS.find(({ name }) => name === setting.name);
    return accuracy === undefined ? [] : [{ ...setting, accuracy }];
  });
  const lines = linesOf(measured, ({ accuracy, error, cost, sameVerdict }) => ({
    error,
    worseError: null,
    cost,
    failures: sameVerdict ? 0 : 1,
    label: accuracy.name === current ? `${current}, in use` : null,
    note: isAccuracyName(accuracy.name) ? accuracy.name : accuracy.contact === 'swept' ? noteOf(accuracy) : null,
  }));
  const title = run === null ? `${level}: she drifts` : `${level}: ${run}`;
  const subtitle = ['Error and time of every setting for this level and run, measured in this browser.'];
  return drawDiagram({ title, subtitle, runs: 1, floor: 0, lines }, ground);
}
