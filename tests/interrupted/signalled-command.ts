import { spawn } from 'node:child_process';
import {
  closeSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  openSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { interruptAt, projectFolder } from './step.ts';

/** Commands whose end by a signal is looked at; each works in a folder that holds `FILES`. */
export const SIGNALLED_COMMANDS = {
  accuracy: 'accuracy a.level.json --svg accuracy.svg',
  check: 'check long --max-time 60 --format json --jobs 1',
  'check --require-slack': 'check long untidy --max-time 60 --require-slack 1 --jobs 2',
  'check --cache-dir': 'check untidy --cache-dir cache/deep --format json --jobs 1',
  simulate: 'simulate a.level.json --holds none --max-time 100 --sample 90 --format json',
  inspect: 'inspect long/1.level.json --max-time 3600',
  explain: 'explain',
  solve: 'solve swing.level.json --objective first --effort 400000 --jobs 2 --write',
  difficulty: 'difficulty a.level.json long/1.level.json --effort 20000 --jobs 2 --svg d.svg',
  generate: 'generate --out made/new --seed 2 --difficulty easy --size medium --ingredients none --jobs 2',
  render: 'render a.level.json -o a.png --width 320',
  'render --solve': 'render swing.level.json -o solved.svg --solve 1 --effort 200000',
  fmt: 'fmt untidy',
  import: 'import originals.json --out imported/deep',
} as const;

const THROUGH = {
  version: 1,
  name: 'Straight through',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 170, y: 0 },
  asteroids: [{ x: 100, y: 0, radius: 16 }],
  runs: [{ name: 'hold', holds: [[0, 600]] }],
};
const DRIFT = { ...THROUGH, runs: Array.from({ length: 4 }, (_, i) => ({ name: `${i}`, holds: [] })) };
const ORIGINAL = { player: { x: 0, y: 0 }, target: { x: 170, y: 0, radius: 18 }, asteroids: [{ x: 100, y: 0, radius: '16' }] };

/** A shipped level without its runs. */
function unsolved(slug: string): object {
  const file = JSON.parse(readFileSync(join(projectFolder(), `levels/${slug}.level.json`), 'utf8'));
  return { ...file, $schema: undefined, runs: undefined };
}

const filesOf = (): Readonly<Record<string, unknown>> => ({
  'a.level.json': THROUGH,
  'swing.level.json': unsolved('02-first-swing'),
  'originals.json': Array(12).fill(ORIGINAL),
  ...Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`untidy/${i}.level.json`, { ...THROUGH, name: `${i}` }])),
  ...Object.fromEntries(Array.from({ length: 4 }, (_, i) => [`long/${i}.level.json`, DRIFT])),
});

/** Files of a folder by their paths: what they hold, or `folder`. */
type Content = Readonly<Record<string, string>>;

function contentOf(folder: string): Content {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true });
  return Object.fromEntries(
    entries.map((entry) => {
      const path = join(entry.parentPath, entry.name);
      return [path.slice(folder.length + 1), entry.isFile() ? readFileSync(path, 'latin1') : 'folder'];
    }),
  );
}

interface Ending {
  /** Files and output at the start. */
  readonly start: Content;
  /** Files and output when the signals were sent; null: the command ended before. */
  readonly before: Content | null;
  readonly after: Content;
  readonly code: number | null;
  readonly signal: NodeJS.Signals | null;
  /** How many steps it took; null when it did not end by itself. */
  readonly steps: number | null;
}

/** Runs a command in a folder of its own, and sends it signals before a step; to its end when the step is 0. `of`: which steps count. */
async function run(command: string, number: number, signals: readonly NodeJS.Signals[], of?: string): Promise<Ending> {
  const place = mkdtempSync(join(tmpdir(), 'gq-signal-'));
  try {
    // the output lies beside the files that the command works on
    const home = join(place, 'home');
    for (const [name, content] of Object.entries(filesOf())) {
      const path = join(home, 'work', name);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, JSON.stringify(content));
    }
    const [out, err] = ['out', 'err'].map((name) => openSync(join(home, name), 'w'));
    const start = contentOf(home);
    const [copy, count] = [join(place, 'copy'), join(place, 'count')];
    const main = join(projectFolder(), 'dist/gq/main.js');
    const env = { ...process.env, ...interruptAt({ of, number, signals, copy: { from: home, to: copy }, count }) };
    const child = spawn(process.execPath, [main, ...command.split(' ')], {
      cwd: join(home, 'work'),
      env,
      stdio: ['ignore', out, err],
    });
    const [code, signal] = await new Promise<[number | null, NodeJS.Signals | null]>((resolve, reject) => {
      child.on('error', reject);
      child.on('exit', (...ended) => resolve(ended));
    });
    for (const descriptor of [out, err]) closeSync(descriptor);
    return {
      start,
      before: existsSync(copy) ? contentOf(copy) : null,
      after: contentOf(home),
      code,
      signal,
      steps: existsSync(count) ? Number(readFileSync(count, 'utf8')) : null,
    };
  } finally {
    rmSync(place, { recursive: true });
  }
}

/** A command that has run to its end. */
export interface WholeRun {
  readonly command: string;
  /** How many steps it took; threads make it vary a little. */
  readonly steps: number;
  readonly start: Content;
  readonly after: Content;
}

/** Runs a command to its end. */
export async function runWhole(command: string): Promise<WholeRun> {
  const { start, after, code, steps } = await run(command, 0, []);
  if (code === null || code > 1 || steps === null) throw new Error(`gq ${command} ended with ${code}: ${after.err}`);
  return { command, steps, start, after };
}

/** The name of a file that is not finished. */
const UNFINISHED = /\.gq-edit-[0-9a-f]{16}\.tmp$/;

/** Of a finished file, what is the same in every run: of measured costs, the head and that it goes on to its end. */
function settled(command: string, text: string): string {
  if (command.startsWith('accuracy')) return text.replace(/(<\/desc>)[\s\S]*(<\/svg>\n?)$/, '$1$2');
  // records of the cache have times in them, and a checksum over these
  if (command.includes('--cache-dir')) return text.replace(/^([0-9a-f]{64}) [0-9a-f]{32} \{.*\}\n/gm, '$1\n');
  return text;
}

/**
 * Sends signals to a command before one of its steps. It must end with 130 or 143, or by the signal; a file that is being written is
 * finished (`import` takes back what it wrote), and nothing else is written. A check that may take long prints what is checked.
 * @param of which steps count; all when left out
 * @returns what is wrong; null when the command ended before that step
 */
export async function signalAt(
  whole: WholeRun,
  step: number,
  signals: readonly NodeJS.Signals[],
  of?: string,
): Promise<string[] | null> {
  const { command } = whole;
  const { before, after, code, signal } = await run(command, step, signals, of);
  if (before === null) return null;
  const wrong: string[] = [];
  const end = signal ?? (code === 130 ? 'SIGINT' : code === 143 ? 'SIGTERM' : code);
  if (!signals.some((one) => one === end)) wrong.push(`ended with ${end}`);
  const changed = Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]);
  const isReport = (name: string): boolean =>
    name === 'out' && before.out === '' && command.includes('--require-slack') && after.out.includes('interrupted by a signal');
  const finished = changed.filter((name) => !UNFINISHED.test(name) && !isReport(name));
  const left = Object.keys(after).filter((name) => UNFINISHED.test(name));
  if (left.length > 0) wrong.push(`leaves ${left.join()}`);
  const isImport = command.startsWith('import');
  const sizes = [whole.start, whole.after].map((content) => Object.keys(content).length);
  if (isImport && !sizes.includes(Object.keys(after).length)) wrong.push(`some files are imported: ${finished.join()}`);
  // a folder is made together with the one that it lies in
  const folders = finished.filter((name) => after[name] === 'folder').length;
  if (!isImport && finished.length - Math.max(0, folders - 1) > 1) wrong.push(`goes on to write: ${finished.join()}`);
  for (const name of finished) {
    if (!name.startsWith('work/')) wrong.push(`writes to ${name}: ${after[name]}`);
    else if (!isImport && settled(command, after[name]) !== settled(command, whole.after[name])) wrong.push(`half of ${name}`);
  }
  return wrong;
}
