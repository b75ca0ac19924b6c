import { type ReactNode, useEffect, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';
import { useEditor, useLevel } from '../context/index.ts';
import { LostLegend } from '../lost/index.ts';
import { createCanvasState } from './canvas-state.ts';
import { EndReason } from './EndReason.tsx';
import './canvas.css';
import { CROSSHAIR_HELP } from './crosshair/index.ts';
import { DeathLegend } from './DeathLegend.tsx';
import { DeathTip } from './DeathTip.tsx';
import { HiddenNote } from './HiddenNote.tsx';
import { HoverName } from './HoverName.tsx';
import type { SearchPicture } from './layers/index.ts';
import { CanvasMenu } from './menu/index.ts';
import { Minimap } from './minimap/index.ts';
import { mountCanvas } from './mount-canvas.ts';
import { NotePins } from './notes/index.ts';
import { RepeatPanel } from './RepeatPanel.tsx';
import { RunLossLabel } from './RunLossLabel.tsx';
import { Rulers } from './rulers/index.ts';
import { Measures, ToldLabel } from './ToldLabel.tsx';

interface CanvasViewProps {
  /** What searches show on the canvas; read every frame. */
  readonly search: Pick<StoreApi<SearchPicture>, 'getState'>;
  /** The legend of what searches show. */
  readonly legend: ReactNode;
}

/** The canvas of the level. */
export function CanvasView({ search, legend }: CanvasViewProps) {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef(createCanvasState()).current;
  const cursor = useStore(canvas, (state) => state.cursor);
  const hasCrosshair = useStore(canvas, (state) => state.crosshair !== null);
  const isRepeating = useStore(canvas, (state) => state.isRepeating);
  const said = useRef(createStore<string>(() => '')).current;
  const words = useStore(said);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    return mountCanvas({ element, editor, level, canvas, said, search });
  }, [editor, level, canvas, said, search]);

  return (
    <>
      <div
        ref={host}
        className="canvas"
        style={{ cursor }}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: keys use the tools and move the selection
        tabIndex={0}
        role="application"
        aria-label="Level canvas"
        aria-description={CROSSHAIR_HELP}
      />
      <p className={`canvas__said${hasCrosshair ? '' : ' canvas__said--unseen'} numbers`} role="status" aria-label="Crosshair">
        {words}
      </p>
      <EndReason canvas={canvas} />
      <RunLossLabel canvas={canvas} />
      <HoverName canvas={canvas} />
      <ToldLabel canvas={canvas} />
      <Measures canvas={canvas} />
      <Rulers canvas={canvas} host={host} />
      <Minimap canvas={canvas} />
      <NotePins canvas={canvas} host={host} />
      {isRepeating && <RepeatPanel onClose={() => canvas.setState({ isRepeating: false })} />}
      <CanvasMenu canvas={canvas} host={host} />
      <div className="legends">
        <HiddenNote />
        {legend}
        <LostLegend />
        <DeathLegend />
      </div>
      <DeathTip canvas={canvas} host={host} />
    </>
  );
}
