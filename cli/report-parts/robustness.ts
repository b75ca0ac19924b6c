import { plural } from '../../check/words/index.ts';
import { TICK } from '../../engine/basics/index.ts';
import type { RobustnessReport } from '../../schema/index.ts';
import type { Robustness } from '../../solver/index.ts';

const SIGMAS = ['p30', 'p40', 'p60', 'p80'] as const;

/** The robustness of a run as in JSON reports. */
export function robustnessJson(robustness: Robustness): RobustnessReport {
  const { p30, p40, p60, p80, certifiedTicks, decided, slack } = robustness;
  const interval = ({ low, high }: typeof p30): [number, number] => [low, high];
  return {
    p30: p30.p,
    p40: p40.p,
    p60: p60.p,
    p80: p80.p,
    certifiedTicks,
    decided,
    slack: slack.map(({ earlier, later }) => [earlier, later]),
    intervals: { p30: interval(p30), p40: interval(p40), p60: interval(p60), p80: interval(p80) },
    samples: p40.samples,
  };
}

/** `99.2 %`; 100 % and 0 % only if the value is exactly that. */
export function percent(share: number): string {
  if (share === 0 || share === 1) return `${100 * share} %`;
  return `${Math.min(99.9, Math.max(0.1, 100 * share)).toFixed(1)} %`;
}

/** The robustness of a run for people: lines with a label and a value. */
export function robustnessLines(robustness: Robustness): [label: string, text: string][] {
  const { certifiedTicks: ticks, slack, p40, decided } = robustness;
  const success = SIGMAS.map((key) => `${percent(robustness[key].p)} at ${robustness[key].sigma} ms`).join(', ');
  const sure =
    ticks === 0
      ? ''
      : `${plural(ticks, 'tick')} (${(1000 * ticks * TICK).toFixed(0)} ms): all presses and releases may be off by up to that, in every combination`;
  const beyond = decided ? '' : `; ${plural(ticks + 1, 'tick')} undecided: too many combinations to try`;
  const all = (sure || (decided ? 'no tick: some combination that is off by one tick fails' : 'no tick')) + beyond;
  const edges = slack.map(
    ({ earlier, later }, i) => `${i % 2 === 0 ? 'press' : 'release'} ${1 + (i >> 1)} -${earlier} +${later}`,
  );
  const lines: [string, string][] = [
    ['success', `${success} of timing noise`],
    ['', `at 40 ms between ${percent(p40.low)} and ${percent(p40.high)}, from ${p40.samples} attempts`],
    ['certified', all],
  ];
  for (let i = 0; i < edges.length; i += 4)
    lines.push([i === 0 ? 'slack' : '', `${edges.slice(i, i + 4).join(', ')}${i + 4 < edges.length ? ',' : ' ticks'}`]);
  return lines;
}
