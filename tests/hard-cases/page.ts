import { ACCURACIES, accuracyOf, compile, DEFAULT_MAX_WORK, type Outcome, simulate } from '../../engine/index.ts';
import { compareAll } from '../../engine/work-precision/index.ts';
import { renderSvg } from '../../picture/index.ts';
import type { Level } from '../../schema/index.ts';
import { type PageCase, type Section, sections } from './sections.ts';

/** How engines of games are usually made: semi-implicit Euler, and contacts are tested once a frame. */
export const NAIVE = accuracyOf({ integrator: 'euler', rate: 60, tolerance: null, contact: 'frame' });

const METHODS = [NAIVE, ACCURACIES.fast, ACCURACIES.standard, ACCURACIES.precise];

/** Below this an error is that of rounding, px. */
export const ROUNDING = 1e-12;

const WORDS: Record<Outcome, string> = {
  completed: 'completed',
  collided: 'collided',
  lost: 'lost',
  timeout: 'not over',
};

const px = (error: number): string => (error < ROUNDING ? `< ${ROUNDING}` : figure(error));
const figure = (value: number): string => {
  const [digits, exponent] = value.toExponential(1).split('e').map(Number);
  return exponent >= -2 && exponent < 4 ? String(Number(value.toPrecision(2))) : `${digits}e${exponent}`;
};

/** The row of a case: its name, how it ends, the error of each setting with another outcome, how exactly that is known. */
export function rowOf({ name, level, holds, maxTime }: PageCase): string {
  const unhurried = { now: () => 0, budget: { comparing: 1, timing: 1, most: 1 } };
  const { reference, methods } = compareAll(level, holds, { maxTime, maxWork: DEFAULT_MAX_WORK, methods: METHODS, ...unhurried });
  const { outcome, time, knownTo } = reference;
  const end = outcome === 'timeout' ? WORDS.timeout : `${WORDS[outcome]}, ${time.toFixed(2)} s`;
  const cells = methods.map((method) => {
    // without two references that agree there is nothing to be off from
    const error = knownTo === null ? '-' : px(method.error);
    return method.sameVerdict ? error : `**${WORDS[method.outcome]}**, ${error}`;
  });
  const known = knownTo === null ? 'by other means' : knownTo === 0 ? '0' : `1e${Math.ceil(Math.log10(knownTo))}`;
  return `| ${[name, end, ...cells, known].join(' | ')} |`;
}

const HEAD = ['case', 'truth', 'naive, px', '`fast`, px', '`standard`, px', '`precise`, px', 'known to, px'];

export const pictureOf = ({ slug }: Section): string => `docs/hard-cases-${slug}.svg`;

/** Far away stands what a level must have and a case has no use for, px. */
const FAR = 5e4;

/** The level as it is drawn: without what is far away. */
function nearPart(level: Level): Level {
  const isNear = ({ x, y }: { readonly x: number; readonly y: number }) => Math.hypot(x, y) < FAR;
  const { astronaut, blackHole } = level;
  return {
    ...level,
    asteroids: level.asteroids.filter(isNear),
    // too small to be seen
    blackHole: isNear(blackHole) ? blackHole : { x: astronaut.x, y: astronaut.y, radius: 1e-3 },
  };
}

/** The level of a section's picture with the path of the naive engine, 1, and over it that of `precise`, 2. */
export function draw({ cases, drawn, title }: Section): string {
  const one = cases.find(({ name }) => name === drawn);
  if (one === undefined) throw new Error(`no case ${drawn} in ${title}`);
  const ways = [NAIVE, ACCURACIES.precise].map((accuracy) => ({
    run: simulate(compile(one.level, accuracy), one.holds, { maxTime: one.maxTime }),
    label: accuracy.name,
  }));
  return renderSvg(nearPart(one.level), { ways, width: 640, words: false, title: `${title}: ${one.name}`, note: one.why });
}

/** The page, with the row that `row` makes of each case. */
export function pageText(row: (c: PageCase) => string): string {
  const all = sections();
  const count = all.reduce((sum, { cases }) => sum + cases.length, 0);
  const parts = all.map((section) => {
    const { title, slug, about, cases, drawn } = section;
    const { why } = cases.find(({ name }) => name === drawn) as PageCase;
    return [
      `## ${title}`,
      about.join(' '),
      `![${title}: ${drawn}](hard-cases-${slug}.svg)`,
      `_${drawn}_: ${why}.`,
      [`| ${HEAD.join(' | ')} |`, `|${HEAD.map(() => ' --- ').join('|')}|`, ...cases.map(row)].join('\n'),
    ].join('\n\n');
  });
  return `${[
    '# Hard cases',
    `${count} small scenes in which something is numerically hard, and what is made of them by a naive engine and by this one at three [accuracies](accuracy.md). The naive engine is this one, too, at \`--integrator euler --rate 60 --contact frame\`: semi-implicit Euler, with contacts tested once a frame. It still finds the time of rims, mouths, targets and the speed limit, so that only its steps and its contacts are wrong.`,
    'An error is the largest distance at any tick before the end to [a reference](accuracy.md#the-reference) with 32 digits, and _known to_ is how far a second reference of another method is from it. Where the outcome is another one, it stands in bold, and the error says little. Below 1e-12 px there is only rounding. _By other means_: the references leave the case out or end it in two ways, since 32 digits do not decide it, and its truth is a closed form or a construction.',
    'In the pictures, 1 is the naive engine, and 2, over it, `precise`, which no picture can tell from the reference; thick where the gun is held. The cases are those of [tests/hard-cases](../tests/hard-cases), which say why each is hard. The page is made by `npm run docs:outputs`, and the same test holds it to the code.',
    ...parts,
  ].join('\n\n')}\n`;
}
