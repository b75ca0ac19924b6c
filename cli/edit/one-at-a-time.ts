import { randomBytes } from 'node:crypto';
import { closeSync, constants, linkSync, lstatSync, openSync, renameSync, rmdirSync, rmSync, writeSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { setTimeout } from 'node:timers/promises';
import { readRegularFile } from '../regular-file.ts';
import { Refusal } from './refusal.ts';

const LOCK = '.gq-edit.lock';

/** A lock that was moved aside to be removed; a process that was killed leaves one behind. */
export const ASIDE = /^\.gq-edit\.lock\.[0-9a-f]{16}$/;

/** bytes: what a lock says is shorter */
const LONGEST = 1024;

/** ms; a change takes a few, so what is older was left by a process that is no more, or that sleeps */
const STALE_AFTER = 10_000;

/** ms between two tries, and how many there are: together longer than it takes until a lock is stale */
const WAIT = 10;
const TRIES = 1500;

/**
 * Does synchronous work while no other `gq edit` on the same folder does any: what one of them has compared with the disk,
 * another can't change before it is replaced. Other programs know nothing of this.
 * @throws Refusal when others go on for too long, and what the operating system says when the folder can't be written
 */
export async function oneAtATime<T>(root: string, work: () => T): Promise<T> {
  const path = join(root, LOCK);
  const mine = `${process.pid} ${hostname()} ${randomBytes(8).toString('hex')}`;
  for (let tries = 0; !take(path, mine); tries++) {
    if (tries >= TRIES) {
      throw new Refusal(
        'busy',
        `another gq edit has locked ${path}`,
        'Try again. If no other gq edit is running, remove that file.',
      );
    }
    removeStale(path);
    await setTimeout(WAIT);
  }
  try {
    return work();
  } finally {
    release(path, mine);
  }
}

function release(path: string, mine: string): void {
  try {
    // after a long sleep somebody else may hold it
    if (contentOf(path) === mine) rmSync(path, { force: true });
  } catch {
    // the work is done all the same; the lock grows stale
  }
}

function take(path: string, mine: string): boolean {
  let descriptor: number;
  try {
    descriptor = openSync(path, 'wx', 0o600);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'EEXIST') return false;
    throw error;
  }
  try {
    writeSync(descriptor, mine);
    return true;
  } catch (error) {
    rmSync(path, { force: true });
    throw error;
  } finally {
    closeSync(descriptor);
  }
}

function removeStale(path: string): void {
  if (!isFileOrNothing(path)) {
    removeForeign(path);
    return;
  }
  const seen = contentOf(path);
  if (seen === null || !isStale(path, seen)) return;
  const aside = `${path}.${randomBytes(8).toString('hex')}`;
  try {
    renameSync(path, aside);
    // between the look and the move another process may have done the same, and taken the lock
    if (contentOf(aside) !== seen) linkSync(aside, path);
  } catch {
    // somebody else was quicker
  }
  rmSync(aside, { force: true });
}

function isStale(path: string, content: string): boolean {
  const [pid, host] = content.split(' ');
  if (host === hostname() && isDead(Number(pid))) return true;
  const stats = lstatSync(path, { throwIfNoEntry: false });
  // one from a time to come was made by a clock that was wrong
  return stats !== undefined && Math.abs(Date.now() - stats.mtimeMs) > STALE_AFTER;
}

const isFileOrNothing = (path: string): boolean => lstatSync(path, { throwIfNoEntry: false })?.isFile() ?? true;

/** No `gq edit` makes a link, a pipe or a folder its lock. @throws Refusal when it can't be removed without a loss */
function removeForeign(path: string): void {
  try {
    if (lstatSync(path).isDirectory()) rmdirSync(path);
    else rmSync(path);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT' || isFileOrNothing(path)) return;
    throw new Refusal('not-writable', `${path} is in the way: it is not a file of gq edit`, 'Move it away, then save again.');
  }
}

function isDead(pid: number): boolean {
  try {
    process.kill(pid, 0);
    return false;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'ESRCH';
  }
}

function contentOf(path: string): string | null {
  try {
    return Buffer.from(readRegularFile(path, LONGEST, constants.O_NOFOLLOW ?? 0)).toString();
  } catch {
    return null;
  }
}
