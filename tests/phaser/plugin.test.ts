import { describe, expect, it, vi } from 'vitest';
import { makePlugin } from '../../phaser/plugin.ts';
import { shipped } from '../levels/shipped-pack.ts';
import { FakePage, fakeScene } from './fake-phaser.ts';

/** What a scene plugin of Phaser stands on. */
class ScenePlugin {
  constructor(readonly scene: unknown) {}
}

const Phaser = { VERSION: '4.2.1', Plugins: { ScenePlugin } };

describe('the plugin', () => {
  it.each([
    ['Phaser', Phaser],
    ['the namespace of a CommonJS build', { default: { ...Phaser, VERSION: '3.90.0' } }],
  ])('runs levels in its scene, and lists the runners in use: %s', (_, phaser) => {
    const page = new FakePage();
    page.install();
    const fake = fakeScene(page);
    const Plugin = makePlugin(phaser);
    const plugin = new Plugin(fake.scene);
    const [one, other] = [plugin.run(shipped('first-swing').level), plugin.run(shipped('vault').level, { input: false })];
    expect(plugin).toBeInstanceOf(ScenePlugin);
    expect(plugin.runners).toEqual([one, other]);
    fake.frame(0);
    fake.frame(50);
    expect([one.player.tick, other.player.tick]).toEqual([3, 3]);
    one.destroy();
    expect(plugin.runners).toEqual([other]);
    fake.events.emit('shutdown');
    expect([plugin.runners, fake.listeners(), fake.alive.size]).toEqual([[], 0, 0]);
    vi.unstubAllGlobals();
  });

  it.each([
    [undefined, /found undefined\. Phaser 3\.90 to 4\.x is supported/],
    [{}, /found an object without VERSION/],
    [{ VERSION: '2.20.2' }, /found Phaser 2\.20\.2/],
    [{ VERSION: '3.80.1' }, /found Phaser 3\.80\.1/],
    [{ VERSION: '5.0.0' }, /expected Phaser 3\.90 to 4\.x, found Phaser 5\.0\.0/],
  ])('refuses %j by name', (phaser, message) => {
    expect(() => makePlugin(phaser as never)).toThrow(message);
  });
});
