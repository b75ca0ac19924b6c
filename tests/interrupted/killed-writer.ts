import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { readLevel } from '../../schema/index.ts';
import { type Interruption, interruptAt, projectFolder } from './step.ts';

// kill -9 at any step of a program that changes a folder of levels: every file is whole, what was acknowledged is there, and the
// next program goes on

const levelText = (name: string): string =>
  `${JSON.stringify({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 170, y: 0 } }, null, 2)}\n`;

/** Levels that are moved, put in order, deleted and restored, but never written. */
const UNWRITTEN: Readonly<Record<string, string>> = {
  moved: levelText('moved'),
  gone: levelText('gone'),
  'ring/01': levelText('1'),
  'ring/02': levelText('2'),
  'ring/03': levelText('3'),
};
const OLD = 'old';
const NEW = 'new';

/** Does one of each change, and says when one is acknowledged. */
const WRITER = `
  import { writeSync } from 'node:fs';
  const { openLevelFolder } = await import(process.env.BUILT);
  const levels = openLevelFolder(process.cwd(), 'levels');
  const tag = (id) => levels.read(id).etag;
  await levels.write('kept', process.env.TEXT, { etag: tag('kept') }, 'c');
  writeSync(1, 'written');
  await levels.order('ring', ['ring/02', 'ring/03', 'ring/01'], 'c');
  await levels.rename('moved', 'moved-2', tag('moved'), 'c');
  await levels.rename('moved-2', 'moved', tag('moved-2'), 'c');
  const { trashed } = await levels.remove('gone', tag('gone'), 'c');
  await levels.restore(trashed.trash, undefined, 'c');
`;

/** What is wrong after the writer was killed at a step, and whether it was. */
export interface Killed {
  /** Steps of a writer that ended by itself. */
  readonly steps: number | null;
  readonly wrong: readonly string[];
}

/**
 * Runs a writer in a folder of its own, kills it before one of its steps, and looks at what it leaves.
 * @param number of the step; 0: to its end
 * @param of which steps count
 */
export async function killWriterAt(number: number, of = 'change'): Promise<Killed> {
  const place = mkdtempSync(join(tmpdir(), 'gq-killed-'));
  try {
    const folder = join(place, 'levels');
    for (const [id, text] of Object.entries({ ...UNWRITTEN, kept: levelText(OLD) })) {
      const path = join(folder, `${id}.level.json`);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, text);
    }
    const count = join(place, 'count');
    const said = await write(folder, { of, number, signals: ['SIGKILL'], count });
    const steps = existsSync(count) ? Number(readFileSync(count, 'utf8')) : null;
    return { steps, wrong: [...wrongFiles(folder, said), ...(await wrongAfterwards(folder))] };
  } finally {
    rmSync(place, { recursive: true, force: true });
  }
}

/** @returns what the writer said before it ended */
function write(folder: string, interruption: Interruption): Promise<string> {
  const BUILT = pathToFileURL(join(projectFolder(), 'dist/cli/serve/level-folder.js')).href;
  const child = spawn(process.execPath, ['--input-type=module', '-e', WRITER], {
    cwd: folder,
    env: { ...process.env, ...interruptAt(interruption), BUILT, TEXT: levelText(NEW) },
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  let said = '';
  child.stdout.on('data', (data: Buffer) => {
    said += data.toString();
  });
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (code, signal) => {
      if (signal === 'SIGKILL' || code === 0) resolve(said);
      else reject(new Error(`the writer ended with ${signal ?? code}`));
    });
  });
}

function wrongFiles(folder: string, said: string): string[] {
  const wrong: string[] = [];
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.level.json'));
  const texts = files.map((file) => readFileSync(join(folder, file), 'utf8'));
  for (const [id, text] of Object.entries(UNWRITTEN)) if (!texts.includes(text)) wrong.push(`${id} is lost`);
  for (const [i, text] of texts.entries()) if (!readLevel(text).ok) wrong.push(`${files[i]} is not whole`);
  const kept = readLevel(readFileSync(join(folder, 'kept.level.json')));
  const name = kept.ok ? kept.level.name : null;
  if (name !== NEW && (said === 'written' || name !== OLD)) wrong.push(`kept is ${name}`);
  return wrong;
}

/** The next program goes on, though a lock may be left. */
async function wrongAfterwards(folder: string): Promise<string[]> {
  const lock = join(folder, '.gq-edit.lock');
  // one that does not say yet whose it is would be waited for until it is old
  if (existsSync(lock) && readFileSync(lock, 'utf8') === '') utimesSync(lock, 0, 0);
  const levels = openLevelFolder(folder, 'levels');
  const next = await levels.write('kept', levelText('next'), { etag: levels.read('kept').etag ?? '' }, 'c');
  return next.entry.name === 'next' ? [] : [`the next program wrote ${next.entry.name}`];
}
