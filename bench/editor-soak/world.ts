import { chmodSync, chownSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import type { Page } from 'playwright-core';
import { type KillableBrowser, startBrowser } from './browser.ts';
import { FILE, soakLevel } from './level.ts';
import { becomesSaved, crash, looksOn, openPage, takeOver } from './person.ts';
import { type KillableServer, startServer } from './server.ts';

/**
 * Number of a user who owns nothing else. Root may write everything, so if root runs the test, the server runs as this user.
 */
const NOBODY = 65534;

export type Victim = 'page' | 'browser' | 'server';

/** A folder, a server on it, a browser, and its pages; each can be killed. */
export class World {
  readonly folder = mkdtempSync(join(tmpdir(), 'gq-soak-'));
  private readonly profile = mkdtempSync(join(tmpdir(), 'gq-soak-profile-'));
  private readonly user = process.getuid?.() === 0 ? NOBODY : undefined;
  private server: KillableServer | null = null;
  private port = 0;
  private browser: KillableBrowser | null = null;
  /** Pages that are alive, and whether they belong to an earlier server; the first one is the one that writes. */
  private pages: { readonly page: Page; readonly isStale: boolean }[] = [];
  readonly kills: Record<Victim, number> = { page: 0, browser: 0, server: 0 };

  constructor() {
    writeFileSync(join(this.folder, FILE), soakLevel());
    if (this.user === undefined) return;
    for (const path of [this.folder, join(this.folder, FILE)]) chownSync(path, this.user, this.user);
  }

  /** The page that writes. */
  get page(): Page {
    return this.pages[0].page;
  }

  get hasServer(): boolean {
    return this.server !== null;
  }

  /** Allows or forbids writing to the folder. */
  allowWriting(isAllowed: boolean): void {
    chmodSync(this.folder, isAllowed ? 0o755 : 0o555);
  }

  /** Opens another page, which is read-only. */
  async openAnother(): Promise<void> {
    if (this.browser === null || this.server === null) throw new Error('nothing to open it with');
    const page = await openPage(this.browser, this.server.address);
    this.pages.push({ page, isStale: false });
    await looksOn(page);
  }

  async killPage(how: 'crash' | 'close'): Promise<void> {
    const [{ page }] = this.pages.splice(0, 1);
    this.kills.page++;
    if (how === 'crash') await crash(page);
    await page.close();
    // both may have been in one process
    this.pages = this.pages.filter((other) => !other.page.isClosed());
  }

  async killBrowser(): Promise<void> {
    this.kills.browser++;
    this.pages = [];
    await this.browser?.kill();
    this.browser = null;
  }

  /**
   * Kills the server.
   * @param asItWrites - as soon as the level's file has changed, which is mostly before the server has responded
   */
  async killServer(asItWrites = false): Promise<void> {
    if (this.server === null) return;
    this.kills.server++;
    if (asItWrites) await this.server.killOnChange(this.folder, FILE);
    else await this.server.kill();
    this.server = null;
    this.pages = this.pages.map(({ page }) => ({ page, isStale: true }));
  }

  /**
   * Starts what is missing, and opens a page that may write the level.
   * @param old - what happens to pages of an earlier server: closed first, or left open until another one has taken the level
   * over
   */
  async mend(old: 'close' | 'leave', isFull = false): Promise<void> {
    const { folder, user } = this;
    this.server ??= await startServer({ folder, port: this.port, user, isFull });
    this.port = this.server.port;
    this.browser ??= await startBrowser(this.profile);
    const stale = this.pages.filter(({ isStale }) => isStale);
    const close = () => Promise.all(stale.map(({ page }) => page.close()));
    if (old === 'close') await close();
    this.pages = this.pages.filter(({ isStale }) => !isStale);
    if (this.pages.length === 0) {
      const page = await openPage(this.browser, this.server.address);
      this.pages.push({ page, isStale: false });
      if (old === 'leave' && stale.length > 0) {
        await looksOn(page);
        await takeOver(page);
      }
    }
    if (old === 'leave') await close();
  }

  /** Waits until everything is on the disk, and leaves one page open. */
  async settle(): Promise<void> {
    await this.page.bringToFront();
    await becomesSaved(this.page);
    const [, ...others] = this.pages.splice(0, this.pages.length, this.pages[0]);
    await Promise.all(others.map(({ page }) => page.close()));
  }

  async end(): Promise<void> {
    await this.browser?.kill().catch(() => undefined);
    await this.server?.kill().catch(() => undefined);
    this.allowWriting(true);
    for (const path of [this.folder, this.profile]) rmSync(path, { recursive: true, force: true });
  }
}
