import type { AccuracyName } from '../../engine/index.ts';
import { formatLevel, type Hold, type LevelFile, leavingFolder, type OwnRules } from '../../schema/index.ts';

/** Levels as the game plays them one after the other. */
export interface Pack {
  readonly title: string;
  /** What the levels were checked with, so that they play the same. */
  readonly accuracy: AccuracyName;
  /** The longest that a play may last, s, as in the check. */
  readonly maxTime: number;
  readonly levels: readonly {
    /** The name under which progress is kept: the path of its file below the folder, without `.level.json`. */
    readonly id: string;
    /** The heading that it stands below, if there is one. */
    readonly chapter?: string;
    /** The content of a level file. */
    readonly level: unknown;
  }[];
}

/** What a pack says of a level beside its file. */
interface PackedLevelOptions {
  /** The rules of its folder. */
  readonly rules: OwnRules;
  /** Whether it keeps its runs, which give the solution away. */
  readonly withRuns: boolean;
  /** A run that a search found; null: none. */
  readonly found: readonly Hold[] | null;
}

/** Of the file only: where its schema lies, what its check allows, and what a merge left open. */
const LEFT_OUT: ReadonlySet<string> = new Set(['$schema', 'allow', 'conflicts']);

/**
 * A level as it leaves its folder for a pack: with the rules of the folder, and without what concerns only those who work on it,
 * such as keys that begin with `x-` and the notes of runs.
 */
export function packedLevel(file: LevelFile, { rules, withRuns, found }: PackedLevelOptions): unknown {
  const { runs = [], ...rest } = leavingFolder(file, rules);
  const own = runs.map(({ notes: _, ...run }) => run);
  const all = found === null ? own : [...own, { name: freeName(runs), holds: found.map(([a, b]): [number, number] => [a, b]) }];
  const whole = withRuns && all.length > 0 ? { ...rest, runs: all } : rest;
  const isOurs = (key: string): boolean => key.startsWith('x-');
  const value = JSON.parse(formatLevel(whole), (key, inner) => (isOurs(key) ? undefined : inner)) as Record<string, unknown>;
  return Object.fromEntries(Object.entries(value).filter(([key]) => !LEFT_OUT.has(key)));
}

function freeName(runs: readonly { readonly name: string }[]): string {
  const taken = new Set(runs.map(({ name }) => name));
  let name = 'solution';
  for (let i = 2; taken.has(name); i++) name = `solution-${i}`;
  return name;
}

/** JSON that is safe in any script: no tag ends in it, and no line separator breaks an old reader. */
const inScript = (value: unknown): string =>
  JSON.stringify(value).replace(/[<\u2028\u2029]/g, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, '0')}`);

/** A classic script that hands a pack to the game. Each level is a line, so that a new version differs little. */
export function packScript({ title, accuracy, maxTime, levels }: Pack): string {
  const lines = levels.map((level) => `    ${inScript(level)},\n`).join('');
  return `globalThis.GRAVITY_QUEST_PACK = {
  "title": ${inScript(title)},
  "accuracy": ${inScript(accuracy)},
  "maxTime": ${inScript(maxTime)},
  "levels": [
${lines}  ],
};
`;
}

/** The file of a pack beside the page that plays it. */
export const PACK_FILE = 'pack.js';

/** Nothing comes from other hosts, and no script but the page's own files runs. */
const POLICY = [
  "default-src 'none'",
  "script-src 'self'",
  // the game sets styles of its own elements
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "media-src 'self' data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/**
 * The page of the game, for one pack: with its title, and with the pack loaded before the game.
 * @param page the page that was built from the game
 * @param policy the Content-Security-Policy of the page
 * @throws if it is not such a page
 */
export function pageOf(page: string, title: string, policy: string = POLICY): string {
  const parts: readonly [what: string, pattern: RegExp, text: string][] = [
    ['a title', /<title>[^<]*<\/title>/, `<title>${escaped(title)}</title>`],
    [
      'its character set',
      /<meta charset="utf-8"\s*\/?>/i,
      `<meta charset="utf-8">\n    <meta http-equiv="Content-Security-Policy" content="${escaped(policy)}">`,
    ],
    ['a script', /(?=<script\b)/, `<script src="./${PACK_FILE}"></script>\n    `],
  ];
  const bare = page
    .replace(/<meta http-equiv="Content-Security-Policy"[^>]*>\s*/i, '')
    .replace(/<script\b[^>]*src="(?:\.\/)?pack\.js"[^>]*><\/script>\s*/i, '');
  return parts.reduce((text, [what, pattern, replacement]) => {
    if (!pattern.test(text)) throw new Error(`the page of the game is not as expected: it lacks ${what}`);
    return text.replace(pattern, () => replacement);
  }, bare);
}
