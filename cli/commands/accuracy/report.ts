import { ACCURACIES, type Accuracy } from '../../../engine/index.ts';
import { FEWEST_ROUNDS, GOOD_ENOUGH, type Measured, type WorkPrecision } from '../../../engine/work-precision/index.ts';
import { brief, errorIn, runsASecond, settingsInGroups, unmeasuredInWords } from '../../../picture/accuracy/index.ts';
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
  costSpread: [cost.minimum, cost.high] as [number, number],
  ...(cost.rounds < FEWEST_ROUNDS && { rounds: cost.rounds }),
  outcome,
  time,
  sameVerdict,
});

/** The results of `accuracy` as JSON: errors in px, costs in microseconds per simulated second, times in s. */
export function accuracyJson({ level, terms, holds, measured, cheapest }: AccuracyReport): string {
  const { method, tolerance, outcome, time, knownTo, doubt } = measured.reference;
  const report: AccuracyJson = {
    version: 1,
    level,
    terms,
    holds: holds.map(([press, release]) => [press, release]),
    reference: { method, tolerance, outcome, time, knownTo, doubt },
    methods: measured.methods.map(methodJson),
    unmeasured: measured.unmeasured.map(({ accuracy, time, why }) => ({ name: accuracy.name, time, why })),
    cheapest:
      cheapest === null
        ? null
        : { name: cheapest.accuracy.name, below: GOOD_ENOUGH, error: cheapest.error, cost: cheapest.cost.minimum },
  };
  return `${JSON.stringify(report)}\n`;
}

const COLUMNS = ['setting', 'error, px', 'cost, us/s', 'runs/s', 'end', 'frame tests: cost', 'end'];
const RIGHT = [1, 2, 3, 5];

/** The results of `accuracy` for people: all settings, the named ones, and a summary. */
export function accuracyPretty(report: AccuracyReport, colors: Colors, width: number | null = null): string {
  const { level, run, measured, cheapest, asked } = report;
  const { reference, methods } = measured;
  const how = `${reference.outcome} at ${reference.time.toFixed(6)} s`;
  let text = `${colors.bold(visibleLine(level))}, ${visibleLine(run)}: ${how}\n`;
  text += `An error is the largest distance, at ticks before the end, from a reference: ${reference.method}.\n`;
  text +=
    reference.knownTo === null
      ? `${colors.red('Careful')}: ${reference.doubt}. Errors in brackets are no more than differences from that run.\n`
      : `It is known to ${brief(reference.knownTo)} px: so far is a second reference, which integrates and locates events in another way.\n`;
  text += 'A cost is in microseconds of computing per simulated second, the least of many measurements;\n';
  text +=
    'runs/s is how many times a second of one core plays this run. A game at 60 Hz needs cost / 10,000 % of each frame.\n\n';

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
    rows.push([
      nameIn(accuracy),
      errorIn(m.error, reference.knownTo),
      brief(m.cost.minimum),
      runsASecond(m.cost.minimum, m.time),
      end(m),
      ...pair,
    ]);
    colored.push(m === cheapest ? colors.green : m.sameVerdict ? (line) => line : colors.red);
  }
  if (rows.length > 0)
    text += alignColumns(rows, { right: RIGHT, head: COLUMNS, lead: 0, width })
      .map((line, i) => (line === '' && i === 0 ? '' : `${colored[i](line)}\n`))
      .join('');

  text += `\n${conclusion(report)}`;
  if (asked !== null) {
    const m = methods.find(({ accuracy }) => accuracy.name === asked.name);
    if (m !== undefined) {
      const { minimum, high } = m.cost;
      text += `${asked.name}: error ${errorIn(m.error, reference.knownTo)} px, ${brief(minimum)} us/s (a quarter of the measurements above ${brief(high)}), ${end(m)}\n`;
    }
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

function conclusion({ terms, measured: { methods, reference, unmeasured }, cheapest }: AccuracyReport): string {
  let text = [...unmeasuredInWords(terms.maxWork, unmeasured), ''].join('\n');
  const hasty = methods.filter(({ cost }) => cost.rounds < FEWEST_ROUNDS);
  if (hasty.length > 0) text += `Timed fewer than ${FEWEST_ROUNDS} times, as the time was used up: ${settingsInGroups(hasty)}.\n`;
  if (methods.length === 0) return text;
  const failed = methods.filter((m) => !m.sameVerdict);
  text +=
    failed.length === 0
      ? 'The outcome is the same at every setting.\n'
      : `${failed.length} of ${methods.length} settings have another outcome than ${reference.outcome}: ${settingsInGroups(failed, methods)}.\n`;
  if (cheapest === null) return `${text}No setting has the same outcome and an error below ${GOOD_ENOUGH} px.\n`;
  const { name } = cheapest.accuracy;
  text += `Cheapest with the same outcome and an error below ${GOOD_ENOUGH} px: ${name} (${brief(cheapest.cost.minimum)} us/s, ${brief(cheapest.error)} px)`;
  const precise = methods.find(({ accuracy }) => accuracy.name === ACCURACIES.precise.name);
  if (precise === undefined || precise === cheapest) return `${text}.\n`;
  return `${text};\nprecise costs ${brief(precise.cost.minimum / cheapest.cost.minimum)} times as much, with an error of ${brief(precise.error)} px.\n`;
}
