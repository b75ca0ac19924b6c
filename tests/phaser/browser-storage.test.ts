import { afterEach, expect, it, vi } from 'vitest';
import { createPack } from '../../game/index.ts';
import { browserStorage } from '../../phaser/index.ts';
import { shipped } from '../levels/shipped-pack.ts';

afterEach(() => vi.unstubAllGlobals());

it('the storage of the browser keeps the progress of a pack', () => {
  const kept = new Map<string, string>();
  const getItem = (key: string) => kept.get(key) ?? null;
  const setItem = (key: string, value: string) => kept.set(key, value);
  vi.stubGlobal('localStorage', { getItem, setItem });
  const levels = [{ id: 'one', level: shipped('first-swing').level }];
  createPack(levels, browserStorage()).record('one', { tick: 7, minerals: 0, play: null });
  expect(createPack(levels, browserStorage()).best('one')).toEqual({ tick: 7, minerals: 0, play: null });
});

it('is null where there is none, and where the browser refuses it', () => {
  vi.stubGlobal('localStorage', undefined);
  expect(browserStorage()).toBeNull();
  vi.stubGlobal('localStorage', null);
  expect(browserStorage()).toBeNull();
  const descriptor = Object.getOwnPropertyDescriptor(globalThis, 'localStorage');
  Object.defineProperty(globalThis, 'localStorage', {
    configurable: true,
    get() {
      throw new DOMException('refused', 'SecurityError');
    },
  });
  expect(browserStorage()).toBeNull();
  Object.defineProperty(globalThis, 'localStorage', descriptor as PropertyDescriptor);
});
