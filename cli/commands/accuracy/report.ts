import { ACCURACIES, type Accuracy } from '../../../engine/index.ts';
import { GOOD_ENOUGH, type Measured, type WorkPrecision } from '../../../engine/work-precision/index.ts';
import type { AccuracyReport as AccuracyJson, Hold, TermsReport } from '../../../schema/index.ts';
import { alignColumns } from '../../report-parts/index.ts';
import { type Colors, visibleLine } from '../../terminal/index.ts';

/** The results of `accuracy` for a run of a level. */
export interface AccuracyReport {
  readonly file: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  /** The level's name. */
  readonly level: string;
  /** The name of the run. */
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly measured: WorkPrecision;
  /** The cheapest setting with the reference's outcome and an error below {@link GOOD_ENOUGH}. */
  readonly cheapest: Measured | null;
  /** The setting that the command line asks for. */
  readonly asked: Accuracy | null;
}

const methodJson = ({ accuracy, error, cost, outcome, time, sameVerdict }: Measured) => ({
  name: accuracy.name,
  integrator: accuracy.integrator,
  ...(accuracy.rate === null ? { tolerance: accuracy.tolerance } : { rate: accuracy.rate }),
  contact: accuracy.contact,
  error,
  cost: cost.minimum,
  medianCost: cost.median,
  outcome,
  time,
  sameVerdict,
});

/** The results of `accuracy` as JSON: errors in px, costs in microseconds per simulated second, times in s. */
export function accuracyJson({ level, terms, holds, measured, cheapest }: AccuracyReport): string {
  const { tolerance, outcome, time, floor } = measured.reference;
  const report: AccuracyJson = {
    version: 1,
    level,
    terms,
    holds: holds.map(([press, release]) => [press, release]),
    reference: { tolerance, outcome, time, floor },
    methods: measured.methods.map(methodJson),
    cheapest: { below: GOOD_ENOUGH, name: cheapest?.accuracy.name ?? null },
  };
  return `${JSON.stringify(report)}\n`;
}

const COLUMNS = ['setting', 'error, px', 'cost, us/s', 'end', 'frame tests: cost', 'end'];
const RIGHT = [1, 2, 4];

/** A length, a time or a cost with two significant digits: 12, 0.034, 5.6e-7. */
export function brief(value: number): string {
  if (value === 0) return '0';
  if (value < 1e-3 || value >= 1e5) return value.toExponential(1);
  return value >= 100 ? value.toFixed(0) : String(Number(value.toPrecision(2)));
}

/** The results of `accuracy` for people: all settings, the named ones, and a summary. */
export function accuracyPretty(report: AccuracyReport, colors: Colors, width: number | null = null): string {
  const { level, run, measured, cheapest, asked } = report;
  const { reference, methods } = measured;
  const how = `${reference.outcome} at ${reference.time.toFixed(6)} s`;
  let text = `${colors.bold(visibleLine(level))}, ${visibleLine(run)}: ${how}\n`;
  text += `An error is the largest distance, at ticks before the end, from a run at tolerance ${reference.tolerance.toExponential()} px. That run is itself `;
  text += `known to ${brief(reference.floor)} px,\nthe limit set by rounding of doubles. A cost is in microseconds of computing per simulated second.\n\n`;

  const end = (m: Measured): string => {
    if (!m.sameVerdict) return `! ${m.outcome} at ${m.time.toFixed(3)} s`;
    const late = m.time - reference.time;
    if (Math.abs(late) < 1e-9) return m.outcome;
    return `${m.outcome} ${brief(Math.abs(late) * 1000)} ms ${late > 0 ? 'later' : 'earlier'}`;
  };
  const rows: (readonly string[])[] = [];
  const colored: ((line: string) => string)[] = [colors.bold];
  let before: string | null = null;
  for (const m of methods) {
    const { accuracy } = m;
    if (accuracy.contact === 'frame' && accuracy.integrator !== 'arcade' && hasSwept(methods, accuracy)) continue;
    if (before !== null && before !== accuracy.integrator) {
      rows.push([]);
      colored.push((line) => line);
    }
    before = accuracy.integrator;
    const frame = accuracy.contact === 'swept' ? methods.find((other) => isFrameOf(other.accuracy, accuracy)) : undefined;
    const pair = frame === undefined ? [] : [brief(frame.cost.minimum), end(frame)];
    rows.push([nameIn(accuracy), brief(m.error), brief(m.cost.minimum), end(m), ...pair]);
    colored.push(m === cheapest ? colors.green : m.sameVerdict ? (line) => line : colors.red);
  }
  text += alignColumns(rows, { right: RIGHT, head: COLUMNS, lead: 0, width })
    .map((line, i) => (line === '' && i === 0 ? '' : `${colored[i](line)}\n`))
    .join('');

  text += `\n${conclusion(report)}`;
  if (asked !== null) {
    const m = methods.find(({ accuracy }) => accuracy.name === asked.name);
    if (m !== undefined) text += `${asked.name}: error ${brief(m.error)} px, ${brief(m.cost.minimum)} us/s, ${end(m)}\n`;
  }
  return text;
}

const isFrameOf = (other: Accuracy, { integrator, rate, tolerance }: Accuracy): boolean =>
  other.contact === 'frame' && other.integrator === integrator && other.rate === rate && other.tolerance === tolerance;

const hasSwept = (methods: readonly Measured[], frame: Accuracy): boolean =>
  methods.some(({ accuracy }) => accuracy.contact === 'swept' && isFrameOf(frame, accuracy));

/** `rk4 60 Hz = standard` */
function nameIn({ name, integrator, rate, tolerance }: Accuracy): string {
  if (!Object.hasOwn(ACCURACIES, name)) return name;
  const size = rate === null ? `${tolerance?.toExponential()} px` : `${rate} Hz`;
  return integrator === 'arcade' ? name : `${integrator} ${size} = ${name}`;
}

function conclusion({ measured: { methods, reference }, cheapest }: AccuracyReport): string {
  const failed = methods.filter((m) => !m.sameVerdict);
  let text =
    failed.length === 0
      ? 'The outcome is the same at every setting.\n'
      : `${failed.length} of ${methods.length} settings have another outcome than ${reference.outcome}: ${inGroups(failed, methods)}.\n`;
  if (cheapest === null) return `${text}No setting has the same outcome and an error below ${GOOD_ENOUGH} px.\n`;
  const { name } = cheapest.accuracy;
  text += `Cheapest with the same outcome and an error below ${GOOD_ENOUGH} px: ${name} (${brief(cheapest.cost.minimum)} us/s, ${brief(cheapest.error)} px)`;
  const precise = methods.find(({ accuracy }) => accuracy.name === ACCURACIES.precise.name);
  if (precise === undefined || precise === cheapest) return `${text}.\n`;
  return `${text};\nprecise costs ${brief(precise.cost.minimum / cheapest.cost.minimum)} times as much, with an error of ${brief(precise.error)} px.\n`;
}

/** Names settings, with whole groups in short: `every euler with frame tests, verlet 15 Hz`. */
function inGroups(failed: readonly Measured[], methods: readonly Measured[]): string {
  const groupOf = ({ accuracy: { integrator, contact } }: Measured): string =>
    integrator === 'arcade' ? integrator : `every ${integrator} with ${contact === 'frame' ? 'frame tests' : 'swept contacts'}`;
  const groups = new Set(failed.map(groupOf));
  return [...groups]
    .map((group) => {
      const own = failed.filter((m) => groupOf(m) === group);
      const whole = own.length === methods.filter((m) => groupOf(m) === group).length;
      return whole ? group : own.map(({ accuracy }) => accuracy.name).join(', ');
    })
    .join('; ');
}
