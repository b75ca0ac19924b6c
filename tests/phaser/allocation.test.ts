import { Session } from 'node:inspector/promises';
import { afterAll, expect, it, vi } from 'vitest';
import { createRunner } from '../../phaser/index.ts';
import { shipped } from '../levels/shipped-pack.ts';
import { FakePage, fakeScene } from './fake-phaser.ts';

afterAll(() => vi.unstubAllGlobals());

interface SampledNode {
  readonly callFrame: { readonly url: string };
  readonly selfSize: number;
  readonly children: readonly SampledNode[];
}

/** Bytes that were allocated by functions of files whose address contains a text. */
function bytesOf(node: SampledNode, of: string): number {
  const own = node.callFrame.url.includes(of) ? node.selfSize : 0;
  return node.children.reduce((sum, child) => sum + bytesOf(child, of), own);
}

const FRAMES = 3000;
/** Bytes a frame: numbers that are handed to a game object may be boxed, a few of them. An object or an array per frame is more. */
const MOST = { '/phaser/': 800, '/game/player/': 30 };

it('a frame allocates next to nothing in runner, skin and player', async () => {
  const page = new FakePage();
  page.install();
  const fake = fakeScene(page);
  const { level } = shipped('watchdog');
  const ghosts = [{ name: 'best', holds: level.runs[0].holds }];
  const runner = createRunner(fake.scene, level, { maxTime: 3600, ghosts, replay: [] });
  let time = 0;
  const frames = (count: number) => {
    for (let i = 0; i < count; i++) {
      time += 1000 / 60;
      fake.frame(time);
      if (runner.player.ending !== null) runner.restart();
    }
  };
  // until V8 has compiled what runs often
  frames(20_000);
  const session = new Session();
  session.connect();
  await session.post('HeapProfiler.startSampling', {
    samplingInterval: 128,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  } as never);
  frames(FRAMES);
  const { profile } = await session.post('HeapProfiler.stopSampling');
  session.disconnect();
  runner.destroy();
  for (const [of, most] of Object.entries(MOST)) {
    const bytes = bytesOf(profile.head as unknown as SampledNode, of) / FRAMES;
    expect([of, bytes < most ? 'few' : bytes]).toEqual([of, 'few']);
  }
  // the profiler sees what is allocated
  expect(profile.head.children.length).toBeGreaterThan(0);
});
