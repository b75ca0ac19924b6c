/// <reference lib="dom" />
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { DRAGGED } from '../../tests/scenes/playable-level.ts';
import type { Stage } from './stage.ts';
import { type Cost, costs } from './trace.ts';

/** How the canvas shows a level: the zoom that the page displays, and where its middle is. */
interface Aim {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export interface Extent {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

const canvas = (page: Page) => page.getByRole('application', { name: 'Level canvas' });

async function boxOf(page: Page, name: 'canvas' | 'time'): Promise<Aim> {
  const box = await (name === 'canvas' ? canvas(page) : page.getByRole('slider', { name: 'Time' })).boundingBox();
  if (box === null) throw new Error(`the ${name} is not seen`);
  return { left: box.x, top: box.y, width: box.width, height: box.height };
}

/**
 * Margin around the level when all of it is shown, px, as in `editor/canvas`: at most a share of the canvas. The tools above it
 * come in addition.
 */
const marginOf = (size: number): number => Math.min(60, 0.125 * size);
const TOOLS = 24;

/**
 * Shows the whole level.
 * @returns a function from places in the level to places on the page
 */
async function aim(page: Page, extent: Extent): Promise<(x: number, y: number) => [x: number, y: number]> {
  await canvas(page).focus();
  await page.keyboard.press('f');
  const { left, top, width, height } = await boxOf(page, 'canvas');
  const zoom = Math.min(
    2,
    (width - 2 * marginOf(width)) / (extent.right - extent.left),
    (height - 2 * marginOf(height) - TOOLS) / (extent.bottom - extent.top),
  );
  const shown = `${Math.round(zoom * 100)} %`;
  // otherwise it would measure a drag of nothing
  if (!(await isSoon(page.getByText(shown, { exact: true }))))
    throw new Error(`the level is not shown at ${shown}: did the canvas change?`);
  const [midX, midY] = [(extent.left + extent.right) / 2, (extent.top + extent.bottom) / 2];
  return (x, y) => [left + width / 2 + (x - midX) * zoom, top + height / 2 + (y - midY) * zoom + TOOLS / 2];
}

const isSoon = (what: Locator): Promise<boolean> =>
  what.waitFor({ timeout: 10_000 }).then(
    () => true,
    () => false,
  );

/** @throws {Error} if the last step of the history is another one: then nothing was measured */
async function expectStep(page: Page, label: RegExp): Promise<void> {
  const undo = page.getByRole('button', { name: label });
  if (await isSoon(undo)) return;
  const found = await page.getByRole('button', { name: /undo/i }).first().getAttribute('aria-label');
  throw new Error(`expected a step to undo that is called ${label}, found "${found}": was the object hit?`);
}

/** Moves the pointer in small steps and waits for each. */
async function along(page: Page, steps: number, at: (share: number) => readonly [x: number, y: number]): Promise<void> {
  for (let i = 1; i <= steps; i++) await page.mouse.move(...at(i / steps));
}

/** Sets a mark when something becomes visible on the page. */
const markWhen = (page: Page, name: string, selector: string, text: string): Promise<void> =>
  page.evaluate(
    ([mark, css, wanted]) => {
      const look = () => {
        const found = [...document.querySelectorAll(css)].some((element) => element.textContent?.includes(wanted));
        if (!found) return false;
        performance.mark(mark);
        return true;
      };
      if (look()) return;
      const observer = new MutationObserver(() => look() && observer.disconnect());
      observer.observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
    },
    [name, selector, text] as const,
  );

export async function drag({ page, traced }: Stage, extent: Extent, steps: number): Promise<Cost[]> {
  const at = await aim(page, extent);
  const [x, y] = at(DRAGGED.x, DRAGGED.y);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await along(page, 8, (share) => [x + 20 * share, y]);
  const trace = await traced(() => along(page, steps, (share) => [x + 20 + 40 * share, y + 12 * Math.sin(12 * share)]));
  await page.mouse.up();
  await expectStep(page, /^Undo: Move/);
  await page.keyboard.press('Control+z');
  return costs(trace, 'pointermove');
}

export async function scrub({ page, traced }: Stage, steps: number): Promise<Cost[]> {
  const { left, top, width, height } = await boxOf(page, 'time');
  const at = (share: number) => [left + 5 + (width - 10) * share, top + height / 2] as const;
  await page.mouse.move(...at(0));
  await page.mouse.down();
  await along(page, 6, (share) => at(0.1 * share));
  const trace = await traced(() => along(page, steps, (share) => at(0.1 + 0.8 * share)));
  await page.mouse.up();
  return costs(trace, 'pointermove');
}

/** Undo and redo of moves of the object that the run depends on. */
export async function undo({ page, traced }: Stage, extent: Extent, steps: number): Promise<Cost[]> {
  const at = await aim(page, extent);
  await page.mouse.click(...at(DRAGGED.x, DRAGGED.y));
  for (let i = 0; i < 8; i++) await page.keyboard.press(i % 2 === 0 ? 'ArrowDown' : 'Shift+ArrowDown');
  await expectStep(page, /^Undo: /);
  const trace = await traced(async () => {
    for (let i = 0; i < steps; i++) {
      await page.keyboard.down('Control');
      await page.keyboard.press(i % 2 === 0 ? 'z' : 'y');
      await page.keyboard.up('Control');
    }
  });
  // back to where it was
  await page.keyboard.press('Control+z');
  // of each pair of keys, the one with Ctrl does something
  return costs(trace, 'keydown').filter((_, i) => i % 2 === 1);
}

export async function enterPlay({ page, traced }: Stage, times: number): Promise<Cost[]> {
  const all: Cost[] = [];
  for (let i = 0; i < times; i++) {
    await canvas(page).focus();
    const trace = await traced(async () => {
      await markWhen(page, 'playing', '.play__readout', 's');
      await page.keyboard.press('Space');
      await page.getByRole('application', { name: /^Playtest/ }).waitFor();
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    });
    all.push(...costs(trace, 'keydown', 'playing').slice(0, 1));
    await page.keyboard.press('Escape');
    await page.getByRole('application', { name: /^Playtest/ }).waitFor({ state: 'hidden' });
  }
  return all;
}

/**
 * Switches back and forth between two levels of the same size.
 * @param names - names of the levels; the first one is open
 */
export async function switchLevel({ page, traced }: Stage, names: readonly [string, string], times: number): Promise<Cost[]> {
  const all: Cost[] = [];
  for (let i = 1; i <= times; i++) {
    const name = names[i % 2];
    const trace = await traced(async () => {
      await page.evaluate(() => performance.clearMarks());
      await markWhen(page, 'switched', '.topbar__level', name);
      await page.getByRole('tree', { name: 'Levels' }).getByText(name, { exact: true }).click();
      await page.locator('.topbar__level', { hasText: name }).waitFor();
      await canvas(page).waitFor();
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    });
    all.push(...costs(trace, 'click', 'switched').slice(0, 1));
  }
  return all;
}

/** Turns the wheel back and forth, ten times each way, while everything is selected. */
async function turnWheel(
  { page, traced }: Stage,
  extent: Extent,
  steps: number,
  turn: readonly [x: number, y: number],
  keys: readonly string[],
): Promise<Cost[]> {
  const at = await aim(page, extent);
  await page.mouse.move(...at((extent.left + extent.right) / 2, (extent.top + extent.bottom) / 2));
  await page.keyboard.press('Control+a');
  await page.getByRole('heading', { name: /^[\d,]+ objects$/ }).waitFor();
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve)));
  for (const key of keys) await page.keyboard.down(key);
  const trace = await traced(async () => {
    for (let i = 0; i < steps; i++) {
      const way = i % 20 < 10 ? -1 : 1;
      await page.mouse.wheel(way * turn[0], way * turn[1]);
      // the next one comes in a frame of its own, as from a hand
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
    }
  });
  for (const key of keys) await page.keyboard.up(key);
  await page.keyboard.press('Escape');
  return costs(trace, 'wheel');
}

export const zoomAll = (stage: Stage, extent: Extent, steps: number): Promise<Cost[]> =>
  turnWheel(stage, extent, steps, [0, 60], []);

export const panAll = (stage: Stage, extent: Extent, steps: number): Promise<Cost[]> =>
  turnWheel(stage, extent, steps, [0, 40], ['Shift']);

/**
 * Reloads the page again and again.
 * @returns clock time from there to the frame after the level's name is shown, ms
 */
export async function openPage({ page }: Stage, times: number): Promise<number[]> {
  const all: number[] = [];
  for (let i = 0; i < times; i++) {
    await page.reload({ waitUntil: 'commit' });
    await canvas(page).waitFor();
    all.push(
      await page.evaluate(
        () =>
          new Promise<number>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(performance.now())))),
      ),
    );
    await page
      .getByRole('status', { name: 'Saving' })
      .filter({ hasText: /^saved$/ })
      .waitFor();
  }
  return all;
}

/** A marquee that is drawn over half of the level in steps. */
export async function marquee({ page, traced }: Stage, extent: Extent, steps: number): Promise<Cost[]> {
  const at = await aim(page, extent);
  // px outside the level: nearer, the pointer would take the object in its corner
  const off = 20;
  const corner = at(extent.left, extent.top);
  const from = [corner[0] - off, corner[1] - off] as const;
  const end = at(extent.right, (extent.top + extent.bottom) / 2);
  const to = [end[0] + off, end[1]] as const;
  const trace = await traced(async () => {
    await page.mouse.move(...from);
    await page.mouse.down();
    await along(page, steps, (share) => [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
  });
  await page.mouse.up();
  // otherwise it would measure a drag of nothing
  if (!(await isSoon(page.getByRole('heading', { name: /^[\d,]+ objects$/ })))) throw new Error('the marquee caught nothing');
  // the first one only moves to where it begins
  return costs(trace, 'pointermove').slice(1);
}

/** Drags everything that the marquee has selected. */
export async function dragMany(
  { page, traced }: Stage,
  extent: Extent,
  grip: readonly [x: number, y: number],
  steps: number,
): Promise<Cost[]> {
  const at = await aim(page, extent);
  const [x, y] = at(...grip);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await along(page, 5, (share) => [x + 10 * share, y]);
  const trace = await traced(() => along(page, steps, (share) => [x + 10 + 50 * share, y - 20 * share]));
  await page.mouse.up();
  await expectStep(page, /^Undo: Move [\d,]+ objects/);
  await page.keyboard.press('Control+z');
  return costs(trace, 'pointermove');
}

interface Watch {
  began?: number;
  took?: Promise<number>;
}

/** Clock time from a key or click until something becomes visible that was not, or that has disappeared in between, ms. */
async function until(page: Page, selector: string, text: string, act: () => Promise<void>): Promise<number> {
  await page.evaluate(
    ([css, wanted]) => {
      const watch = globalThis as Watch;
      const isThere = () => [...document.querySelectorAll(css)].some((element) => element.textContent?.includes(wanted));
      const start = (event: Event) => {
        watch.began = event.timeStamp;
      };
      for (const type of ['keydown', 'click']) addEventListener(type, start, { capture: true, once: true });
      watch.took = new Promise((resolve) => {
        let wasGone = !isThere();
        const observer = new MutationObserver(() => {
          if (watch.began === undefined) return;
          if (!isThere()) wasGone = true;
          else if (wasGone) {
            observer.disconnect();
            resolve(performance.now() - watch.began);
          }
        });
        observer.observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
      });
    },
    [selector, text] as const,
  );
  await act();
  return page.evaluate(async () => {
    const watch = globalThis as Watch;
    const took = await watch.took;
    delete watch.began;
    return took as number;
  });
}

/**
 * Colours of the lines of the fan on the canvas, as in `editor/canvas`, on dark and on light. Nothing else is as faint in these
 * colours.
 */
const FAN_LINES = ['rgba(124, 242, 176, 0.22)', 'rgba(11, 122, 69, 0.22)'];

interface FanWatch {
  /** When the last line of a fan was drawn, ms. */
  drawn?: number;
  /** When the object was dropped while no fan was visible; null if an older one was. */
  dropped?: number | null;
}

/** Notes when the canvas draws a line of a fan, and when the pointer is released. */
const watchFans = (page: Page): Promise<void> =>
  page.evaluate((lines) => {
    const watch = globalThis as FanWatch;
    const { stroke } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.stroke = function (this: CanvasRenderingContext2D, ...path: unknown[]) {
      if (lines.some((line) => line === this.strokeStyle)) watch.drawn = performance.now();
      stroke.apply(this, path as [Path2D]);
    };
    const drop = ({ timeStamp }: Event) => {
      // two frames without one
      watch.dropped = timeStamp - (watch.drawn ?? 0) > 40 ? timeStamp : null;
    };
    addEventListener('pointerup', drop, { capture: true });
  }, FAN_LINES);

/** Clock time from the end of a drag to the fan of the new run on the canvas. */
export async function fan({ page }: Stage, extent: Extent, times: number): Promise<number[]> {
  const at = await aim(page, extent);
  await watchFans(page);
  const sinceDrop = () =>
    page.waitForFunction(() => {
      const { drawn = 0, dropped } = globalThis as FanWatch;
      if (dropped === undefined) return false;
      return dropped === null ? { ms: null } : drawn > dropped && { ms: drawn - dropped };
    });
  const all: number[] = [];
  for (let tries = 0; all.length < times; tries++) {
    if (tries > 3 * times) throw new Error('before the object was let go the fan was there: is the machine too busy?');
    await page.mouse.move(...at(DRAGGED.x, DRAGGED.y));
    await page.mouse.down();
    // still on her line: the run completes the level wherever it is dropped
    await along(page, 6, (share) => at(DRAGGED.x + 48 * share, DRAGGED.y));
    await page.mouse.up();
    const told = await (await sinceDrop()).jsonValue();
    if (told !== false && told.ms !== null) all.push(told.ms);
    await page.evaluate(() => {
      delete (globalThis as FanWatch).dropped;
    });
    await page.keyboard.press('Control+z');
  }
  return all;
}

/** Clock time from the key to the first shade of where the object may stand that the run depends on, ms. */
export async function leeway({ page }: Stage, extent: Extent, times: number): Promise<number[]> {
  const at = await aim(page, extent);
  await page.mouse.click(...at(DRAGGED.x, DRAGGED.y));
  const shade = page.getByRole('figure', { name: 'Where the selection may stand' });
  const all: number[] = [];
  for (let i = 0; i < times; i++) {
    // another level each time, so that nothing is known of it
    await page.keyboard.press(i % 2 === 0 ? 'ArrowRight' : 'ArrowLeft');
    await page
      .getByRole('status', { name: 'Saving' })
      .filter({ hasText: /^saved$/ })
      .waitFor();
    all.push(await until(page, '.leeway-legend__note', 'Sampled', () => page.keyboard.press('Shift+L')));
    await page.keyboard.press('Shift+L');
    await shade.waitFor({ state: 'hidden' });
  }
  return all;
}

/** Clock time to the first report of a search, and the cost of stopping it. */
export async function search({ page, traced }: Stage, times: number): Promise<{ first: number[]; cancel: Cost[] }> {
  await page.getByRole('tab', { name: 'Solver' }).click();
  const click = (name: string) => () => page.getByRole('button', { name, exact: true }).click();
  const first: number[] = [];
  const cancel: Cost[] = [];
  for (let i = 0; i < times; i++) {
    first.push(await until(page, '.report .part__note', 'simulations', click('Solve')));
    const trace = await traced(async () => {
      await page.evaluate(() => performance.clearMarks());
      await markWhen(page, 'stopped', '.report', 'topped');
      await click('Cancel')();
      await page.getByText('stopped').first().waitFor();
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    });
    cancel.push(...costs(trace, 'click', 'stopped').slice(0, 1));
    await click('Discard')();
  }
  return { first, cancel };
}

/** Clock time from the last of several edits to the changed file. */
export async function toDisk({ page, folder }: Stage, id: string, extent: Extent, times: number): Promise<number[]> {
  const at = await aim(page, extent);
  await page.mouse.click(...at(DRAGGED.x, DRAGGED.y));
  const file = join(folder, `${id}.level.json`);
  const all: number[] = [];
  for (let i = 0; i < times; i++) {
    const before = existsSync(file) ? readFileSync(file, 'utf8') : '';
    await page.keyboard.press(i % 2 === 0 ? 'ArrowDown' : 'ArrowUp');
    const began = performance.now();
    while (readFileSync(file, 'utf8') === before) {
      if (performance.now() - began > 30_000) throw new Error('an edit did not reach the disk within half a minute');
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    all.push(performance.now() - began);
  }
  return all;
}

/** What the main thread does in each of some seconds in which nobody does anything, ms. */
export async function rest({ page }: Stage, seconds: number): Promise<number[]> {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable');
  const busy = async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return metrics.find(({ name }) => name === 'TaskDuration')?.value ?? Number.NaN;
  };
  // what the level calls for when it is opened is done by then
  await page.waitForTimeout(3000);
  const all: number[] = [];
  for (let i = 0; i < seconds; i++) {
    const [before, began] = [await busy(), performance.now()];
    await page.waitForTimeout(1000);
    all.push((((await busy()) - before) * 1e6) / (performance.now() - began));
  }
  await session.detach();
  return all;
}
