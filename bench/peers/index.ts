import { box2d3 } from './box2d.ts';
import { matter } from './matter.ts';
import { p2es } from './p2.ts';
import type { Peer } from './peer.ts';
import { phaserArcade } from './phaser-arcade.ts';
import { planck } from './planck.ts';
import { rapier } from './rapier.ts';

export * from './peer.ts';

/** Every engine that the toolkit is compared with. */
export const PEERS: readonly Peer[] = [phaserArcade, p2es, planck, matter, rapier, box2d3];

/** Loads all peers, one after the other. */
export async function loadPeers(): Promise<readonly Peer[]> {
  for (const peer of PEERS) await peer.load();
  return PEERS;
}
