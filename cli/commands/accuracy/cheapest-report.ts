import type { CheapestSetting, KeptRun } from '../../../check/index.ts';
import { plural } from '../../../check/words/index.ts';
import { ACCURACIES } from '../../../engine/index.ts';
import { brief, errorIn, settingsInGroups } from '../../../picture/accuracy/index.ts';
import type { CheapestReport as CheapestJson, TermsReport } from '../../../schema/index.ts';
import { alignColumns } from '../../report-parts/index.ts';
import { type Colors, visibleLine } from '../../terminal/index.ts';

/** The results of `accuracy --cheapest`. */
interface CheapestReport {
  readonly found: CheapestSetting;
  readonly terms: TermsReport;
  readonly runs: number;
}

const runJson = ({ file, name }: KeptRun) => ({ file, run: name });

export function cheapestJson({ found: { tried, cheapest, untried, doubts }, terms, runs }: CheapestReport): string {
  const report: CheapestJson = {
    version: 1,
    terms,
    runs,
    tried: tried.map(({ accuracy, cost, broken, error, tightest }) => ({
      name: accuracy.name,
      cost: cost.minimum,
      costSpread: [cost.minimum, cost.high],
      broken: broken && { ...runJson(broken.run), what: broken.what },
      error: error && { ...runJson(error.run), px: error.px },
      tightest: tightest && { ...runJson(tightest.run), share: tightest.share },
    })),
    untried: untried.map(({ name }) => name),
    cheapest: cheapest?.accuracy.name ?? null,
    doubts: doubts.map(({ run, doubt }) => ({ ...runJson(run), doubt })),
  };
  return `${JSON.stringify(report)}\n`;
}

const nameOf = ({ level, name }: KeptRun): string => visibleLine(`${level.name}, "${name}"`);

export function cheapestPretty({ found, runs }: CheapestReport, colors: Colors, width: number | null): string {
  const { tried, doubts } = found;
  const rows = tried.map(({ accuracy, cost, broken }) => [
    accuracy.name,
    brief(cost.minimum),
    broken === null ? `keeps ${runs === 1 ? 'the run' : `all ${runs} runs`}` : `${nameOf(broken.run)}: ${broken.what}`,
  ]);
  const lines = alignColumns(rows, {
    right: [1],
    head: ['setting', 'cost, us/s', 'outcome, minerals and slack'],
    lead: 0,
    width,
  });
  let text = lines.map((line, i) => `${i > 0 && tried[i - 1]?.broken === null ? colors.green(line) : line}\n`).join('');
  text += `\n${conclusion(found, runs)}`;
  for (const { run, doubt } of doubts) text += `${colors.red('Careful')}: ${nameOf(run)}: ${doubt}.\n`;
  return text;
}

function conclusion({ cheapest, tried, untried, doubts }: CheapestSetting, runs: number): string {
  if (cheapest === null) {
    if (untried.length > 0)
      return `No setting was found in time; not tried: ${settingsInGroups(untried.map((accuracy) => ({ accuracy })))}.\n`;
    const precise = tried.find(({ accuracy }) => accuracy.name === ACCURACIES.precise.name);
    const why = precise?.broken == null ? '' : ` Even at precise, ${nameOf(precise.broken.run)} ${precise.broken.what}.`;
    return `No setting keeps ${plural(runs, 'run')}.${why}\n`;
  }
  const { accuracy, cost, error, tightest } = cheapest;
  let text = `Cheapest${doubts.length > 0 ? ', as far as is known' : ''}: ${accuracy.name}, ${brief(cost.minimum)} us a simulated second`;
  if (error !== null) text += `; off by at most ${errorIn(error.px, error.knownTo)} px (${nameOf(error.run)})`;
  if (tightest !== null)
    text += `,\nwhich is at most ${brief(100 * tightest.share)} % of the clearance of a run (${nameOf(tightest.run)})`;
  return `${text}.\n`;
}
