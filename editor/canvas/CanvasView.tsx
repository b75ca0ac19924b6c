import { useEffect, useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import { createStore } from 'zustand/vanilla';
import { useEditor, useLevel } from '../core/context/index.ts';
import { laterPart } from '../core/panel/index.ts';
import { EndReason, HiddenNote, HoverName, Measures, Message } from './CanvasLabels.tsx';
import { CanvasMenu } from './CanvasMenu.tsx';
import { createCanvasState } from './canvas-state.ts';
import { CROSSHAIR_HELP } from './crosshair-commands.ts';
import { mountCanvas } from './mount-canvas.ts';
import { NotePins } from './NotePins.tsx';
import type { NamedPart } from './part.ts';
import { Rulers } from './Rulers.tsx';
import './canvas.css';

// neither is seen at first
const Minimap = laterPart(() => import('./Minimap.tsx').then((there) => there.Minimap));
const RepeatPanel = laterPart(() => import('./RepeatPanel.tsx').then((there) => there.RepeatPanel));

/** The canvas of the level. @param parts what features of the page show on it; the same list at every call */
export function CanvasView({ parts }: { readonly parts: readonly NamedPart[] }) {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef(createCanvasState()).current;
  const cursor = useStore(canvas, (state) => state.cursor);
  const hasCrosshair = useStore(canvas, (state) => state.crosshair !== null);
  const isRepeating = useStore(canvas, (state) => state.isRepeating);
  const said = useRef(createStore<string>(() => '')).current;
  const words = useStore(said);

  const drawn = useMemo(() => parts.flatMap((part) => part.drawn ?? []), [parts]);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    return mountCanvas({ element, editor, level, canvas, said, drawn });
  }, [editor, level, canvas, said, drawn]);

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
      {parts.map(({ name, labels: Labels }) => Labels && <Labels key={name} canvas={canvas} host={host} />)}
      <EndReason canvas={canvas} />
      <HoverName canvas={canvas} />
      <Message canvas={canvas} />
      <Measures canvas={canvas} />
      <Rulers canvas={canvas} host={host} />
      <Minimap canvas={canvas} />
      <NotePins canvas={canvas} host={host} />
      {isRepeating && <RepeatPanel onClose={() => canvas.setState({ isRepeating: false })} />}
      <CanvasMenu canvas={canvas} host={host} />
      <div className="legends">
        <HiddenNote />
        {parts.map(({ name, legend: Legend }) => Legend && <Legend key={name} />)}
      </div>
      {parts.map(({ name, cards: Cards }) => Cards && <Cards key={name} canvas={canvas} host={host} />)}
    </>
  );
}
