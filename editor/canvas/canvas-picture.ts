import type { StoreApi } from 'zustand/vanilla';
import { type Box, joinHolds } from '../../engine/index.ts';
import type { Editor, OpenLevel, Pose } from '../core/context/index.ts';
import { shelfOf } from '../core/shelf/index.ts';
import { raceOf } from '../features/compare/index.ts';
import { type LostPicture, lossKey, lostOf, lostPictureOf } from '../features/lost/index.ts';
import { type OnionPicture, onionOf, onionPictureOf } from '../features/onion/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { SearchPicture } from './layers/index.ts';
import { poseAt } from './run-pose.ts';
import type { Picture } from './stage.ts';

/** What the stage shows of an open level, read once per frame. @param search what searches show */
export function pictureOf(
  editor: Editor,
  level: OpenLevel,
  canvas: StoreApi<CanvasState>,
  search: Pick<StoreApi<SearchPicture>, 'getState'>,
): () => Picture {
  const { settings, session } = editor;
  const { document, selection, hovered, proof, ghosts, playtest, attempts } = level;
  const plays = shelfOf(level).store;
  const found = lostOf(level);
  const compared = onionOf(level);
  const race = raceOf(editor, level);
  // the pose of a tick is computed once, however many frames show it
  let posed: { proof: object; tick: number; pose: Pose } | null = null;
  const pose = (): Pose => {
    const playing = playtest.getState();
    if (playing !== null) return playing.pose();
    const { tick, hoverTick } = session.getState();
    const at = hoverTick ?? tick;
    const now = proof.proof();
    if (posed === null || posed.proof !== now || posed.tick !== at) posed = { proof: now, tick: at, pose: poseAt(now, at) };
    return posed.pose;
  };
  // made anew when one of its parts changes
  let shaded: { readonly parts: readonly unknown[]; readonly lost: LostPicture } | null = null;
  const lost = (): LostPicture | null => {
    const { layers, mode } = session.getState();
    if (!layers.lost || mode === 'play') return null;
    const [findings, now, own] = [found.getState(), proof.proof(), attempts.store.getState()];
    const parts = [findings.losing, findings.losses, now.run, layers.ghosts, own];
    if (shaded === null || parts.some((part, i) => part !== shaded?.parts[i])) {
      const paths = (layers.ghosts ? own : []).map(({ holds, accuracy, points }) => ({
        key: lossKey(joinHolds(holds), accuracy),
        points,
      }));
      shaded = { parts, lost: lostPictureOf(findings, now, paths) };
    }
    return shaded.lost;
  };
  // the same for all frames between two moves of the pointer
  let skin: { readonly former: object; readonly file: object; readonly onion: OnionPicture } | null = null;
  const onion = (): OnionPicture | null => {
    const { former } = compared.getState();
    if (former === null || session.getState().mode === 'play') return null;
    const file = document.file();
    if (skin === null || skin.former !== former || skin.file !== file)
      skin = { former, file, onion: onionPictureOf(former, file) };
    return skin.onion;
  };
  let her = proof.proof().scene.box;
  const box = (): Box => {
    const now = proof.proof().scene.box;
    if (now.halfWidth !== her.halfWidth || now.halfHeight !== her.halfHeight) her = now;
    return her;
  };
  return () => {
    const { snapToGrid, grid } = settings.getState();
    const { dataset } = window.document.documentElement;
    const { racers, tick: moment } = race();
    return {
      file: document.file(),
      her: box(),
      proof: proof.proof(),
      canvas: canvas.getState(),
      selected: selection.keys(),
      hovered: hovered.getState(),
      layers: session.getState().layers,
      grid: snapToGrid ? grid : null,
      ghosts: ghosts.getState(),
      search: search.getState(),
      deaths: plays.getState().deaths,
      lost: lost(),
      onion: onion(),
      pose: pose(),
      racers,
      moment,
      editing: session.getState().mode === 'edit',
      showsRun: session.getState().mode === 'edit' || settings.getState().runInPlay,
      theme: dataset.theme === 'light' ? 'light' : 'dark',
      calm: dataset.motion === 'less',
    };
  };
}
