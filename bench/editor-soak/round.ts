import { readdirSync } from 'node:fs';
import { setTimeout as wait } from 'node:timers/promises';
import type { Random } from '../../solver/index.ts';
import { furthestKept } from './journal-in-page.ts';
import { changeByOthers, countsOnDisk, FILE, START, takeAway, tear } from './level.ts';
import { savingState, selectAll } from './person.ts';
import type { World } from './world.ts';

export const VICTIMS = ['page', 'server', 'browser', 'browser and server'] as const;
export const HAZARDS = [
  'none',
  'two tabs',
  'another program',
  'checkout',
  'file with errors',
  'full disk',
  'read-only folder',
] as const;

export interface Round {
  readonly victims: (typeof VICTIMS)[number];
  readonly hazard: (typeof HAZARDS)[number];
  /** Number of keys pressed. */
  readonly pressed: number;
  /** How often the page had changed the level at the last acknowledgement, and at most. */
  readonly least: number;
  readonly most: number;
  readonly found: number;
  /** For each edit, its age at the kill, ms, and whether it was lost. */
  readonly edits: readonly { readonly age: number; readonly isLost: boolean }[];
  /** What was not as promised. */
  readonly failures: readonly string[];
}

const pick = <T>(random: Random, list: readonly T[]): T => list[random.below(list.length)];

/**
 * Lets something go wrong.
 * @returns a function that puts it right again; null if nothing has to be
 */
async function strike(hazard: Round['hazard'], world: World): Promise<(() => void) | null> {
  const { folder } = world;
  switch (hazard) {
    case 'another program':
      changeByOthers(folder);
      return null;
    case 'checkout':
      return takeAway(folder);
    case 'file with errors':
      return tear(folder);
    case 'read-only folder':
      world.allowWriting(false);
      return () => world.allowWriting(true);
    default:
      return null;
  }
}

/** The counts on the disk; null while the file is missing or has errors. */
function lookAtDisk(folder: string, isWhole: boolean): { page: number; others: number } | null {
  return isWhole ? countsOnDisk(folder) : null;
}

/**
 * Presses keys while something goes wrong, and kills page, browser or server. Then everything is started again, and what was
 * acknowledged must be on the disk: what the page called saved or kept in the browser, what was seen on the disk, and what was
 * in the journal. Of the other edits, those that were lost are counted, with their age at the kill.
 */
export async function playRound(world: World, random: Random): Promise<Round> {
  const victims = pick(random, VICTIMS);
  const hazard = pick(random, HAZARDS);
  const { folder } = world;
  const failures: string[] = [];
  /** When the page had handled each edit: the next key is pressed after that. */
  const doneAt: number[] = [];
  const nudge = async () => {
    await world.page.keyboard.press('ArrowRight');
    doneAt.push(performance.now());
  };
  if (hazard === 'two tabs') await world.openAnother();
  if (hazard === 'full disk') {
    await world.killServer();
    await world.mend('close', true);
  }
  const before = countsOnDisk(folder);
  let { page: least, page: most } = before;
  let mended: (() => void) | null = null;
  const acknowledge = (count: number | null) => {
    if (count !== null && count > most) failures.push(`${count} changes are kept, of ${most} that were made`);
    least = Math.max(least, count ?? least);
  };

  await selectAll(world.page);
  const keys = 1 + random.below(10);
  const strikesAt = random.below(keys);
  // sometimes the server dies before the last key, so that only the journal has the rest
  const serverDiesAt = random.below(4) === 0 ? random.below(keys) : null;
  for (let i = 0; i < keys; i++) {
    if (i === strikesAt) mended = await strike(hazard, world);
    if (i === serverDiesAt) await world.killServer();
    await nudge();
    most++;
    if (random.below(3) === 0) await wait(random.below(150));
  }
  // reading takes time, in which the last edits are kept: many rounds do without
  const isAbrupt = random.below(3) === 0;
  const diesWriting = !isAbrupt && victims !== 'page' && victims !== 'browser' && random.below(2) === 0;
  if (diesWriting) await world.killServer(true);
  // a save begins about 200 ms after the last key: more kills about then
  else if (!isAbrupt && random.below(4) > 0) await wait(random.below(2) === 0 ? random.below(400) : 190 + random.below(40));
  if (!isAbrupt) {
    if (random.below(2) === 0) acknowledge(await furthestKept(world.page).then((x) => (x === null ? null : x - START)));
    const said = await savingState(world.page);
    acknowledge(lookAtDisk(folder, mended === null || hazard === 'read-only folder')?.page ?? null);
    if (said === 'saved' || said.endsWith('kept in this browser')) acknowledge(most);
  }

  if (victims !== 'page' && victims !== 'browser') {
    await world.killServer();
    if (victims === 'server' && random.below(2) === 0) {
      await nudge();
      most++;
      acknowledge(await furthestKept(world.page).then((x) => (x === null ? null : x - START)));
    }
  }
  const killedAt = performance.now();
  if (victims === 'page') await world.killPage(random.below(2) === 0 ? 'crash' : 'close');
  if (victims === 'browser' || victims === 'browser and server') await world.killBrowser();
  // the first server that is started again on a full disk has no more room than the last one
  if (hazard === 'full disk') await world.killServer();
  const old = random.below(2) === 0 ? 'close' : 'leave';
  if (hazard === 'read-only folder' && random.below(2) === 0) {
    await world.mend(old);
    mended?.();
  } else {
    mended?.();
    await world.mend(old);
  }
  await world.settle().catch((error: Error) => {
    const kept = `${least} to ${most} are acknowledged, ${countsOnDisk(folder).page} are on the disk`;
    throw new Error(`${victims}, ${hazard}, ${diesWriting ? 'while writing, ' : ''}old tab: ${old}: ${error.message}; ${kept}`);
  });
  const found = countsOnDisk(folder);
  if (found.page < least || found.page > most) failures.push(`expected ${least} to ${most}, found ${found.page}`);
  const others = before.others + (hazard === 'another program' ? 1 : 0);
  if (found.others !== others) failures.push(`of others expected ${others}, found ${found.others}`);
  const strange = readdirSync(folder).filter((name) => name.endsWith('.level.json') && name !== FILE);
  if (strange.length > 0) failures.push(`other files: ${strange.join()}`);
  // edits are written in order, so the last ones are missing
  const kept = found.page - before.page;
  const edits = doneAt.map((time, i) => ({ age: killedAt - time, isLost: i >= kept }));
  return { victims, hazard, pressed: most - before.page, least, most, found: found.page, edits, failures };
}
