import type { StoreApi } from 'zustand/vanilla';
import type { Box } from '../../engine/index.ts';
import type { Editor, OpenLevel, Pose } from '../core/context/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { type DrawnPart, unchanged } from './part.ts';
import { poseAt } from './run-pose.ts';
import type { Picture } from './stage.ts';

/** What the stage shows of an open level, read once per frame. @param drawn what features of the page draw into it */
export function pictureOf(
  editor: Editor,
  level: OpenLevel,
  canvas: StoreApi<CanvasState>,
  drawn: readonly DrawnPart[],
): () => Picture {
  const { settings, session } = editor;
  const { document, selection, hovered, proof, ghosts, playtest } = level;
  const read = drawn.map((part) => part.pictureOf(editor, level));
  const parts = unchanged(
    () => read.map((picture) => picture()),
    (all) => all,
  );
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
  let her = proof.proof().scene.box;
  const box = (): Box => {
    const now = proof.proof().scene.box;
    if (now.halfWidth !== her.halfWidth || now.halfHeight !== her.halfHeight) her = now;
    return her;
  };
  return () => {
    const { snapToGrid, grid } = settings.getState();
    const { dataset } = window.document.documentElement;
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
      parts: parts(),
      pose: pose(),
      editing: session.getState().mode === 'edit',
      showsRun: session.getState().mode === 'edit' || settings.getState().runInPlay,
      theme: dataset.theme === 'light' ? 'light' : 'dark',
      calm: dataset.motion === 'less',
    };
  };
}
