import { type PointerEvent, useEffect, useMemo, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { STATE_SIZE } from '../../engine/index.ts';
import { appearanceOfObject } from '../../schema/index.ts';
import { useInPace } from '../core/ask/index.ts';
import { useEditor, useLevel, usePageTheme, useSession } from '../core/context/index.ts';
import { type DocumentState, placesOf, radiusOf, visibleIn } from '../core/document/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { COLOURS } from './colours.ts';
import { extentOf } from './extent.ts';
import { type Box, fromMap, isAllInView, type MapView, mapViewOf } from './view.ts';

/** px */
const SIZE = { width: 168, height: 112 } as const;
/** px of screen: a smaller canvas has no room for a map */
const LEAST = { width: 520, height: 320 } as const;
/** px on the map: the radius below which a disc is drawn as a square */
const SMALL = 2;
/** ticks between two points of the run on the map */
const EACH = 6;

const fileOf = ({ file }: DocumentState) => file;
const wayOf = ({ run }: LiveProof) => run.way;

interface MinimapProps {
  readonly canvas: StoreApi<CanvasState>;
}

/** The whole level in a corner while part of it is out of view: objects, the run, and what is in view. A drag moves the view. */
export function Minimap({ canvas }: MinimapProps) {
  const { settings } = useEditor();
  const isOn = useStore(settings, (state) => state.minimap);
  const isEditing = useSession(({ mode }) => mode === 'edit');
  const hasRoom = useStore(canvas, ({ view }) => view.width >= LEAST.width && view.height >= LEAST.height);
  return isOn && isEditing && hasRoom ? <RoomyMap canvas={canvas} /> : null;
}

function RoomyMap({ canvas }: MinimapProps) {
  const level = useLevel();
  // the canvas has priority during a drag
  const file = useInPace(level.document.store, fileOf, 'idle');
  const box = useMemo(() => extentOf(file, level.proof.proof().scene.box), [file, level]);
  const isNeeded = useStore(canvas, ({ view }) => box !== null && !isAllInView(box, view));
  return box === null || !isNeeded ? null : <MapOfLevel canvas={canvas} box={box} />;
}

/** Draws objects and run once per change of the level, not per move of the view. */
function useLevelPicture(map: MapView) {
  const level = useLevel();
  const file = useInPace(level.document.store, fileOf, 'idle');
  const way = useInPace(level.proof.store, wayOf, 'idle');
  const theme = usePageTheme();
  const element = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = element.current?.getContext('2d');
    if (element.current === null || context === null || context === undefined) return;
    const ratio = window.devicePixelRatio;
    element.current.width = SIZE.width * ratio;
    element.current.height = SIZE.height * ratio;
    const colours = COLOURS[theme];
    context.setTransform(ratio * map.scale, 0, 0, ratio * map.scale, ratio * SIZE.width * 0.5, ratio * SIZE.height * 0.5);
    context.translate(-map.x, -map.y);
    const least = 1.5 / map.scale;
    for (const found of visibleIn(file).values()) {
      context.fillStyle = appearanceOfObject(found.kind, found.object).deadly ? colours.danger : colours.label;
      context.globalAlpha = 0.75;
      for (const { x, y } of placesOf(found)) {
        const radius = Math.max(least, radiusOf(found) ?? 10);
        // thousands of small discs would take longer than a frame, and look like squares anyway
        if (radius < SMALL / map.scale) context.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
        else {
          context.beginPath();
          context.arc(x, y, radius, 0, 2 * Math.PI);
          context.fill();
        }
      }
    }
    context.globalAlpha = 1;
    // says nothing about how the run ends
    context.strokeStyle = colours.wayLost;
    context.lineWidth = 1 / map.scale;
    context.beginPath();
    for (let k = 0; k < way.count; k += EACH) context.lineTo(way.states[k * STATE_SIZE], way.states[k * STATE_SIZE + 1]);
    context.stroke();
  }, [file, way, theme, map]);
  return element;
}

function MapOfLevel({ canvas, box }: MinimapProps & { readonly box: Box }) {
  const { session } = useEditor();
  const view = useStore(canvas, (state) => state.view);
  const map = useMemo(() => mapViewOf(box, SIZE.width, SIZE.height), [box]);
  const element = useLevelPicture(map);
  const isHeld = useRef(false);
  const go = (event: PointerEvent<HTMLElement>) => {
    const { left, top } = event.currentTarget.getBoundingClientRect();
    const at = fromMap(map, { x: event.clientX - left, y: event.clientY - top }, SIZE.width, SIZE.height);
    const next = { ...canvas.getState().view, x: at.x, y: at.y };
    canvas.setState({ view: next });
    session.setState({ zoom: next.zoom });
  };
  const width = (view.width / view.zoom) * map.scale;
  const height = (view.height / view.zoom) * map.scale;
  const middle = { x: SIZE.width / 2 + (view.x - map.x) * map.scale, y: SIZE.height / 2 + (view.y - map.y) * map.scale };
  return (
    <div
      className="minimap"
      role="img"
      aria-label="Minimap: drag to move the view"
      style={SIZE}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        isHeld.current = true;
        go(event);
      }}
      onPointerMove={(event) => isHeld.current && go(event)}
      onPointerUp={() => (isHeld.current = false)}
      onPointerCancel={() => (isHeld.current = false)}
    >
      <canvas ref={element} style={SIZE} />
      <span className="minimap__view" style={{ width, height, left: middle.x - width / 2, top: middle.y - height / 2 }} />
    </div>
  );
}
