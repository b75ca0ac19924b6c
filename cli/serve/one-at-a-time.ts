import { randomBytes } from 'node:crypto';
import { closeSync, constants, linkSync, lstatSync, openSync, renameSync, rmdirSync, rmSync, writeSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { setTimeout } from 'node:timers/promises';
import { readRegularFile } from '../io/index.ts';
import { Refusal } from './refusal.ts';

const LOCK = '.gq-edit.lock';

/** The name of a lock that was moved aside to be deleted; a process that is killed leaves it behind. */
export const ASIDE = /^\.gq-edit\.lock\.[0-9a-f]{16}$/;

/** bytes; a lock is shorter */
const LONGEST = 1024;

/** ms; a change takes a few ms, so the process of an older lock has ended or is suspended */
const STALE_AFTER = 10_000;

/** ms between two tries, and their number: together longer than it takes until a lock is stale */
const WAIT = 10;
const TRIES = 1500;

/**
 * Does synchronous work while no other `gq edit` changes the same folder: no other can change a file after it was compared with
 * the disk and before it is replaced. Other programs ignore this lock.
 * @throws Refusal if others hold the lock for too long; a system error if the folder can't be written
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
    // after a long suspension another process may hold the lock
    if (contentOf(path) === mine) rmSync(path, { force: true });
  } catch {
    // the work is done anyway, and the lock becomes stale
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
    // between reading and moving, another process may have removed the stale lock and taken a new one: that one is put back
    if (contentOf(aside) !== seen) linkSync(aside, path);
  } catch {
    // another process was faster
  }
  rmSync(aside, { force: true });
}

function isStale(path: string, content: string): boolean {
  const [pid, host] = content.split(' ');
  if (host === hostname() && isDead(Number(pid))) return true;
  const stats = lstatSync(path, { throwIfNoEntry: false });
  // the absolute difference: a lock from the future was made by a wrong clock
  return stats !== undefined && Math.abs(Date.now() - stats.mtimeMs) > STALE_AFTER;
}

const isFileOrNothing = (path: string): boolean => lstatSync(path, { throwIfNoEntry: false })?.isFile() ?? true;

/** Removes a link, a pipe or a folder in place of the lock. @throws Refusal if that is impossible without a loss */
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
