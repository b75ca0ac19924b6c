import { type StoreApi, useStore } from 'zustand';
import { useLevel, useSession } from '../core/context/index.ts';
import { marksOf, objectsOf, radiusOf } from '../core/document/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { toScreen } from './view.ts';

/** The name that an object under the pointer was given, above it. Outline and inspector have the same names for everybody. */
export function HoverName({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const { hovered, document } = useLevel();
  const key = useStore(hovered);
  const view = useStore(canvas, (state) => state.view);
  const isEditing = useSession(({ mode }) => mode === 'edit');
  const found = key === null ? undefined : objectsOf(document.file()).get(key);
  const name = found === undefined ? null : marksOf(found).name;
  if (found === undefined || name === null || !isEditing) return null;
  const { x, y } = toScreen(view, { x: found.object.x, y: found.object.y - (radiusOf(found) ?? 16) });
  return (
    <div className="canvas__name" aria-hidden style={{ transform: `translate(${x}px, ${y - 8}px) translate(-50%, -100%)` }}>
      {name}
    </div>
  );
}
