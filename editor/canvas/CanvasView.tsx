import { type ReactNode, useEffect, useMemo, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';
import { useEditor, useLevel } from '../core/context/index.ts';
import { LeewayLegend } from '../features/leeway/index.ts';
import { LostLegend } from '../features/lost/index.ts';
import { OnionCard, type OnionSession } from '../features/onion/index.ts';
import { createCanvasState } from './canvas-state.ts';
import { EndReason } from './EndReason.tsx';
import './canvas.css';
import { CROSSHAIR_HELP } from './crosshair/index.ts';
import { DeathLegend } from './DeathLegend.tsx';
import { DeathTip } from './DeathTip.tsx';
import { HiddenNote } from './HiddenNote.tsx';
import { HoverName } from './HoverName.tsx';
import { LeewayShade } from './LeewayShade.tsx';
import type { SearchPicture } from './layers/index.ts';
import { CanvasMenu } from './menu/index.ts';
import { Minimap } from './minimap/index.ts';
import { mountCanvas } from './mount-canvas.ts';
import { NotePins } from './notes/index.ts';
import { OnionLabel } from './OnionLabel.tsx';
import { placesOnPage } from './places-on-page.ts';
import { RepeatPanel } from './RepeatPanel.tsx';
import { RunLossLabel } from './RunLossLabel.tsx';
import { Rulers } from './rulers/index.ts';
import { Measures, ToldLabel } from './ToldLabel.tsx';
import { useLeeway } from './use-leeway.ts';

interface CanvasViewProps {
  /** What searches show on the canvas; read every frame. */
  readonly search: Pick<StoreApi<SearchPicture>, 'getState'>;
  /** The legend of what searches show. */
  readonly legend: ReactNode;
  /** The comparison with what was before a change. */
  readonly onion: OnionSession;
}

/** The canvas of the level. */
export function CanvasView({ search, legend, onion }: CanvasViewProps) {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef(createCanvasState()).current;
  const cursor = useStore(canvas, (state) => state.cursor);
  const hasCrosshair = useStore(canvas, (state) => state.crosshair !== null);
  const isRepeating = useStore(canvas, (state) => state.isRepeating);
  const said = useRef(createStore<string>(() => '')).current;
  const words = useStore(said);

  useLeeway(canvas);
  const places = useMemo(() => placesOnPage(host, level, canvas), [level, canvas]);

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
      <LeewayShade canvas={canvas} />
      <EndReason canvas={canvas} />
      <RunLossLabel canvas={canvas} />
      <OnionLabel canvas={canvas} />
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
        <LeewayLegend />
        <DeathLegend />
      </div>
      <DeathTip canvas={canvas} host={host} />
      <OnionCard onion={onion} {...places} />
    </>
  );
}
