import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { nextFrames } from './frames.ts';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const A = { x: 400, y: 200 };
const B = { x: 560, y: 160 };
const C = { x: 720, y: 240 };

const heading = (page: Page, name: string | RegExp) =>
  page
    .getByRole('region', { name: 'Inspector and tools' })
    .or(page.getByRole('complementary'))
    .getByRole('heading', { name })
    .first();
const outline = (page: Page) => page.getByRole('tree', { name: 'Objects of the level' });
const row = (page: Page, name: RegExp) => outline(page).getByRole('treeitem', { name });

inChromium('locking, hiding and naming in Chromium', ({ on }) => {
  it(
    'what is locked can neither be selected nor changed on the canvas, until it is unlocked',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await page.keyboard.press('Control+Shift+L');
      await until(() => expect(file('01').asteroids?.[0]).toEqual({ id: 'a1', ...A, radius: 32, 'x-locked': true }));
      // the selection stays: fields, keys and Delete leave it as it is and say why
      expect(await page.getByRole('textbox', { name: 'x', exact: true }).isDisabled()).toBe(true);
      await page.getByText('It is locked: unlock it to make changes.').waitFor();
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('Delete');
      await page
        .getByRole('status')
        .getByText('What is selected is locked.')
        .or(page.getByText('What is selected is locked.'))
        .first()
        .waitFor();
      // a click and a marquee pass it by
      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await until(async () => expect(await row(page, /^Asteroid 1/).getAttribute('aria-selected')).toBe('false'));
      await canvas.drag({ x: 340, y: 100 }, { to: [{ x: 620, y: 280 }] });
      await heading(page, 'Asteroid 2').waitFor();
      await page.keyboard.press('Control+a');
      await heading(page, '8 objects').waitFor();
      // together with others it stays where it is
      await row(page, /^Asteroid 1/).click();
      await row(page, /^Asteroid 2/).click({ modifiers: ['Control'] });
      await page.getByText('1 of 2 is locked: unlock it to make changes.').waitFor();
      await canvas.drag(B, { to: [{ x: 560, y: 360 }] });
      await until(() => expect(file('01').asteroids?.[1].y).toBeGreaterThan(300));
      expect(file('01').asteroids?.[0]).toMatchObject(A);
      await page.keyboard.press('Control+z');
      // the row has a lock, which opens
      await row(page, /^Asteroid 1.*locked/)
        .getByTitle('Unlock')
        .click();
      await until(() => expect(file('01')).toEqual(expect.objectContaining(garden())));
      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await heading(page, 'Asteroid 1').waitFor();
      await saved();
    }),
  );

  it(
    'what is hidden is neither drawn nor clickable, is met by the run, and is back in a playtest',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await canvas.click({ x: 560, y: 480 }, ['Shift']);
      const picture = () => page.screenshot({ clip: { x: canvas.at(A).x - 12, y: canvas.at(A).y - 12, width: 24, height: 24 } });
      await page.keyboard.press('Control+Shift+H');
      await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ 'x-hidden': true }));
      expect(file('01').minerals?.[0]).toMatchObject({ 'x-hidden': true });
      const note = page.getByRole('status', { name: 'Hidden objects' });
      await note.getByText('2 objects hidden: the run still meets them').waitFor();
      await canvas.click({ x: 300, y: 100 });
      await nextFrames(page);
      const hidden = await picture();
      await canvas.click(A);
      expect(await outline(page).locator('[aria-selected=true]').count()).toBe(0);
      await row(page, /^Asteroid 1.*hidden/).waitFor();
      // in play it is there
      await page.keyboard.press('Space');
      await page
        .getByRole('button', { name: /Back to editing|Stop|Edit/ })
        .first()
        .waitFor();
      await until(async () => expect(Buffer.compare(await picture(), hidden)).not.toBe(0));
      await page.keyboard.press('Escape');
      await note.waitFor();
      expect(await complaintsAbout(page, 'hidden objects', 'main')).toEqual([]);
      await note.getByRole('button', { name: 'Show' }).click();
      await note.waitFor({ state: 'hidden' });
      await until(() => expect(file('01').asteroids?.[0]).toEqual({ id: 'a1', ...A, radius: 32 }));
      // the astronaut belongs to her run
      await canvas.click({ x: 200, y: 304 });
      await page.keyboard.press('Control+Shift+H');
      await page.getByText('she can’t be hidden').waitFor();
    }),
  );

  it(
    'names objects in the outline by F2 and in the inspector, and shows the names',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await canvas.click(C);
      await page.keyboard.press('F2');
      const field = page.getByRole('textbox', { name: 'Name of Asteroid 3' });
      await until(async () => expect(await field.evaluate((element) => element === document.activeElement)).toBe(true));
      await page.keyboard.type('Gate');
      await page.keyboard.press('Enter');
      await until(() => expect(file('01').asteroids?.[2]).toEqual({ id: 'c1', ...C, radius: 16, 'x-name': 'Gate' }));
      await heading(page, 'Gate').waitFor();
      await row(page, /^Gate/).waitFor();
      await page.mouse.move(canvas.at({ x: 300, y: 100 }).x, canvas.at({ x: 300, y: 100 }).y);
      await page.mouse.move(canvas.at(C).x, canvas.at(C).y);
      await page.locator('.canvas__name').getByText('Gate').waitFor();
      // typed in the inspector, one step
      const name = page.getByRole('textbox', { name: 'name', exact: true });
      await name.fill('Gate 2');
      await name.press('Tab');
      await until(() => expect(file('01').asteroids?.[2]).toMatchObject({ 'x-name': 'Gate 2' }));
      await saved();
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await row(page, /^Asteroid 3/).waitFor();
    }),
  );
});

inChromium('groups in Chromium', ({ on }) => {
  it(
    'are selected by a click, entered by a double-click or Alt, moved and copied as a whole',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await canvas.click(B, ['Shift']);
      await page.keyboard.press('Control+g');
      await until(() =>
        expect(file('01').asteroids?.map((one) => (one as Record<string, unknown>)['x-group'])).toEqual([
          'group 1',
          'group 1',
          undefined,
        ]),
      );
      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await heading(page, '2 objects').waitFor();
      await canvas.drag(B, { to: [{ x: 560, y: 168 }] });
      await until(() => expect(file('01').asteroids?.map(({ y }) => y)).toEqual([208, 168, 240]));
      await page.keyboard.press('Control+z');
      // one member: by Alt, by a double-click, by keys; inside, clicks select members
      await canvas.click(A, ['Alt']);
      await heading(page, 'Asteroid 1').waitFor();
      await canvas.click(B);
      await heading(page, 'Asteroid 2').waitFor();
      await canvas.click({ x: 300, y: 100 });
      const { x, y } = canvas.at(B);
      await page.mouse.dblclick(x, y);
      await heading(page, 'Asteroid 2').waitFor();
      await page.keyboard.press('Alt+Enter');
      await heading(page, 'Asteroid 1').waitFor();
      await page.keyboard.press('Shift+Alt+Enter');
      await heading(page, '2 objects').waitFor();
      // the copy is a group of its own
      await page.keyboard.press('Control+d');
      await row(page, /^group 2/).waitFor();
      // the folder of the outline: rename, lock, ungroup
      await row(page, /^group 1/).click();
      await page.keyboard.press('F2');
      const field = page.getByRole('textbox', { name: 'Name of the group group 1' });
      await field.fill('group 2');
      await page.getByText('There is a group group 2').waitFor();
      await field.fill('ring');
      await field.press('Enter');
      await row(page, /^ring/).waitFor();
      await row(page, /^ring/).hover();
      await row(page, /^ring/).getByTitle('Lock', { exact: true }).click();
      await until(() =>
        expect(file('01').asteroids?.slice(0, 2)).toEqual([
          expect.objectContaining({ 'x-locked': true }),
          expect.objectContaining({ 'x-locked': true }),
        ]),
      );
      await row(page, /^ring/).click({ button: 'right' });
      await page.getByRole('menuitem', { name: 'Ungroup' }).click();
      await row(page, /^ring/).waitFor({ state: 'hidden' });
      expect(await complaintsAbout(page, 'groups', '.outliner')).toEqual([]);
    }),
  );
});

inChromium('what lies at a place in Chromium', ({ on }) => {
  const stack = () => garden({ repulsors: [{ id: 'r1', ...A, radius: 60 }], winds: [{ id: 'w1', x: 410, y: 200, radius: 90 }] });

  it(
    'clicking again selects what lies below, which can be dragged from there; C does the same',
    on({ '01': stack() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const told = page.getByRole('status', { name: 'At this place' });
      await canvas.click(A);
      await told.getByText('1 of 3 here: Asteroid 1').waitFor();
      await canvas.click(A);
      await told.getByText('2 of 3 here: Repulsor 1').waitFor();
      await heading(page, 'Repulsor 1').waitFor();
      await canvas.drag(A, { to: [{ x: 400, y: 304 }] });
      await until(() => expect(file('01').repulsors?.[0]).toMatchObject({ x: 400, y: 304 }));
      expect(file('01').asteroids?.[0]).toMatchObject(A);
      await page.keyboard.press('Control+z');
      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await page.keyboard.press('j');
      await told.getByText('2 of 3 here: Repulsor 1').waitFor();
      await page.keyboard.press('j');
      await told.getByText('3 of 3 here: Wind 1').waitFor();
      await page.keyboard.press('j');
      await told.getByText('1 of 3 here: Asteroid 1').waitFor();
      // elsewhere it begins anew
      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await told.getByText('1 of 3 here').waitFor();
    }),
  );

  it(
    'the right button opens the menu of a place where it is not dragged; the menu key does so at the crosshair',
    on({ '01': stack() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const menu = page.getByRole('menu', { name: 'Menu of the canvas' });
      const { x, y } = canvas.at(A);
      await page.mouse.click(x, y, { button: 'right' });
      await menu.waitFor();
      expect(await complaintsAbout(page, 'menu', '[role=menu]')).toEqual([]);
      await menu.getByRole('menuitem', { name: 'Select here' }).click();
      await page.getByRole('menuitem', { name: 'Wind 1' }).click();
      await heading(page, 'Wind 1').waitFor();
      await menu.waitFor({ state: 'hidden' });
      // a drag moves the view instead
      const zoom = canvas.zoom();
      await canvas.drag({ x: 300, y: 100 }, { to: [{ x: 340, y: 100 }], button: 'right' });
      expect(await menu.count()).toBe(0);
      await canvas.fit(file('01'));
      expect(canvas.zoom()).toBe(zoom);
      // an empty place: add there, paste there
      const empty = canvas.at({ x: 302, y: 102 });
      await page.mouse.click(empty.x, empty.y, { button: 'right' });
      await menu.getByRole('menuitem', { name: 'Add here' }).click();
      await page.getByRole('menuitem', { name: 'Nova', exact: true }).click();
      await until(() => expect(file('01').novae).toContainEqual(expect.objectContaining({ x: 304, y: 104 })));
      await page.keyboard.press('Control+c');
      const other = canvas.at({ x: 304, y: 560 });
      await page.mouse.click(other.x, other.y, { button: 'right' });
      await menu.getByRole('menuitem', { name: 'Paste here' }).click();
      await until(() => expect(file('01').novae).toHaveLength(3));
      expect(file('01').novae?.[2]).toMatchObject({ x: expect.closeTo(304, -1), y: expect.closeTo(560, -1) });
      // by key, at the selected object: lock it, then unlock what is here
      await page.keyboard.press('Shift+F10');
      await menu.getByRole('menuitem', { name: /Lock or unlock/ }).press('Enter');
      await until(() => expect(file('01').novae?.[2]).toMatchObject({ 'x-locked': true }));
      await menu.waitFor({ state: 'hidden' });
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Escape');
      await page.mouse.click(other.x, other.y, { button: 'right' });
      await menu.getByRole('menuitem', { name: 'Unlock Nova 3' }).click();
      await until(() => expect(file('01').novae?.[2]).not.toHaveProperty('x-locked'));
    }),
  );

  it(
    'a finger that rests opens the menu, with targets that it hits',
    on(
      { '01': stack() },
      async ({ page, canvas, file, context }) => {
        await canvas.fit(file('01'));
        const { x, y } = canvas.at({ x: 560, y: 160 });
        const touch = await context.newCDPSession(page);
        await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
        const menu = page.getByRole('menu', { name: 'Menu of the canvas' });
        await menu.waitFor();
        await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
        await menu.getByRole('menuitem', { name: 'Duplicate' }).waitFor();
        for (const item of await menu.getByRole('menuitem').all())
          expect((await item.boundingBox())?.height).toBeGreaterThanOrEqual(44);
        await menu.getByRole('menuitem', { name: 'Duplicate' }).tap();
        await until(() => expect(file('01').asteroids).toHaveLength(4));
      },
      { context: { viewport: { width: 1280, height: 800 }, hasTouch: true } },
    ),
  );
});
