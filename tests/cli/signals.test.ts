import { spawn } from 'node:child_process';
import { closeSync, cpSync, existsSync, mkdirSync, mkdtempSync, openSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { setTimeout } from 'node:timers/promises';
import { afterAll, describe, expect, it } from 'vitest';
import { fallThrough, MAIN, makeFiles } from './gq.ts';
import { withoutRuns } from './levels.ts';

// A signal ends every command with 130 or 143, whenever it comes, and nothing is written after it. The process is stopped at a moment that
// nobody has chosen, what it has written by then is looked at, the signal is sent, and it goes on. More moments: GQ_SIGNALS=500.

const MOMENTS = Number(process.env.GQ_SIGNALS ?? 6);

const drift = fallThrough({ runs: Array.from({ length: 4 }, (_, i) => ({ name: `${i}`, holds: [] })) });
const original = { player: { x: 0, y: 0 }, target: { x: 170, y: 0, radius: 18 }, asteroids: [{ x: 100, y: 0, radius: '16' }] };
const files = makeFiles({
  'a.level.json': fallThrough(),
  'swing.level.json': withoutRuns('02-first-swing'),
  'originals.json': JSON.stringify(Array(60).fill(original)),
  ...Object.fromEntries(Array.from({ length: 80 }, (_, i) => [`untidy/${i}.level.json`, fallThrough({ name: `${i}` })])),
  ...Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`long/${i}.level.json`, drift])),
});
const pattern = files.directory;
afterAll(files.remove);

const COMMANDS: readonly string[] = [
  'accuracy a.level.json --svg accuracy.svg',
  'check long --max-time 600 --format json --jobs 1',
  'check long untidy --max-time 600 --require-slack 1 --jobs 2',
  'simulate a.level.json --holds none --max-time 100 --sample 9000 --format json',
  'inspect long/1.level.json --max-time 3600',
  'explain',
  'solve swing.level.json --effort 100000 --jobs 2 --write',
  'difficulty a.level.json long/1.level.json --effort 20000 --jobs 2 --svg d.svg',
  'generate --out made/new --count 2 --effort 700000 --difficulty easy --size small --ingredients none --jobs 2',
  'render a.level.json -o a.png --width 1600',
  'render swing.level.json -o solved.svg --solve 1 --effort 200000',
  'fmt untidy',
  'import originals.json --out imported/deep',
];

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

/** R, S, T (stopped), Z (ended): what the kernel says of a process. */
const stateOf = (pid: number): string => {
  const stat = readFileSync(`/proc/${pid}/stat`, 'latin1');
  return stat.slice(stat.lastIndexOf(')') + 2, stat.lastIndexOf(')') + 3);
};

interface Ending {
  /** Files, and what was said, when the signal was sent; null: the process had ended by itself. */
  readonly before: Content | null;
  readonly after: Content;
  readonly code: number | null;
  readonly signal: NodeJS.Signals | null;
  /** ms */
  readonly lasted: number;
}

/** Runs a command in a folder of its own; `moment`: ms after which it is stopped and sent these signals. */
async function run(args: string, moment: number | null, signals: readonly NodeJS.Signals[]): Promise<Ending> {
  const home = mkdtempSync(join(tmpdir(), 'gq-signal-'));
  const folder = join(home, 'work');
  mkdirSync(folder);
  cpSync(pattern, folder, { recursive: true });
  const [out, err] = ['out', 'err'].map((name) => openSync(join(home, name), 'w'));
  const start = performance.now();
  const child = spawn(process.execPath, [MAIN, ...args.split(' ')], { cwd: folder, stdio: ['ignore', out, err] });
  const pid = child.pid as number;
  const ended = new Promise<[number | null, NodeJS.Signals | null]>((resolve) =>
    child.on('exit', (code, signal) => resolve([code, signal])),
  );
  let before: Content | null = null;
  if (moment !== null) {
    await setTimeout(moment);
    if (child.kill('SIGSTOP')) {
      // synchronously: once this process comes to its event loop, the other may be gone
      while (existsSync(`/proc/${pid}`) && !'TZ'.includes(stateOf(pid)));
      if (existsSync(`/proc/${pid}`) && stateOf(pid) === 'T') {
        before = contentOf(home);
        for (const signal of signals) child.kill(signal);
        child.kill('SIGCONT');
      }
    }
  }
  const [code, signal] = await ended;
  const lasted = performance.now() - start;
  for (const descriptor of [out, err]) closeSync(descriptor);
  const after = contentOf(home);
  rmSync(home, { recursive: true });
  return { before, after, code, signal, lasted };
}

/** out, err, and the folder itself */
const ASIDE = 3;

const UNFINISHED = /\.gq-edit-[0-9a-f]{16}\.tmp$/;

/** What of a finished file is the same in every run: of measured costs, the head and that it goes on to its end. */
const settled = (args: string, text: string): string =>
  args.startsWith('accuracy') ? text.replace(/(<\/desc>)[\s\S]*(<\/svg>\n?)$/, '$1$2') : text;

describe.runIf(process.platform === 'linux')('a signal at any moment', () => {
  it.each(COMMANDS)('of gq %s', async (args) => {
    const whole = await run(args, null, []);
    expect(whole.code, whole.after.err).toBeLessThan(2);
    let heard = 0;
    let tries = 0;
    const lane = async (): Promise<void> => {
      // a command that ends before its moment is no test: on a busy machine one may take a part of the time of another
      while (heard < MOMENTS && tries++ < 20 * MOMENTS) {
        const first = Math.random() < 0.5 ? 'SIGINT' : 'SIGTERM';
        const signals: NodeJS.Signals[] = Math.random() < 0.3 ? [first, 'SIGTERM', 'SIGINT'] : [first];
        const { before, after, code, signal } = await run(args, Math.random() * whole.lasted, signals);
        if (before === null) continue;
        heard++;
        const end = signal ?? (code === 130 ? 'SIGINT' : code === 143 ? 'SIGTERM' : code);
        expect(signals).toContain(end);
        const changed = Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]);
        const finished = changed.filter((name) => !UNFINISHED.test(name));
        // a file that was being written is finished; import takes back the others
        if (args.startsWith('import')) {
          expect([ASIDE + Object.keys(contentOf(pattern)).length, Object.keys(whole.after).length]).toContain(
            Object.keys(after).length,
          );
        } else {
          // a folder is made together with the one that it lies in
          const folders = finished.filter((name) => after[name] === 'folder');
          expect(finished.length - Math.max(0, folders.length - 1), finished.join()).toBeLessThan(2);
        }
        for (const name of finished) {
          expect(name).toMatch(/^work\//);
          if (!args.startsWith('import')) expect(settled(args, after[name])).toBe(settled(args, whole.after[name]));
        }
        expect(Object.keys(after).filter((name) => UNFINISHED.test(name))).toEqual([]);
      }
    };
    await Promise.all([lane(), lane()]);
    expect(heard, 'signals that came in time').toBeGreaterThanOrEqual(MOMENTS);
  });
});
