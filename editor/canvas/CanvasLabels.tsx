import { EyeOff } from 'lucide-react';
import { type StoreApi, useStore } from 'zustand';
import { useDocument, useEditor, useLevel, useProof, useSession } from '../core/context/index.ts';
import { hiddenIn, marksOf, objectsOf, radiusOf } from '../core/document/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import { Button } from '../core/ui/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { reasonOf, reasonPlace } from './label-places.ts';
import { type Point, toScreen, type View } from './view.ts';

const endX = ({ run }: LiveProof): number => run.way.last[0];
const endY = ({ run }: LiveProof): number => run.way.last[1];
const wayOf = ({ run }: LiveProof): LiveProof['run']['way'] => run.way;

/** Why the shown run fails, beside the place where it fails. */
export function EndReason({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const { settings } = useEditor();
  const isEdited = useSession(({ mode }) => mode === 'edit');
  const inPlay = useStore(settings, ({ runInPlay }) => runInPlay);
  const reason = useProof(reasonOf);
  const x = useProof(endX);
  const y = useProof(endY);
  const way = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  if (reason === null || !(isEdited || inPlay)) return null;
  const place = reasonPlace(reason, { x, y }, way, view);
  return (
    <div
      className="canvas__reason"
      role="note"
      aria-label="Where the run ends"
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)` }}
    >
      {reason}
    </div>
  );
}

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

/** Beside a place, towards the middle of the view. */
function beside(view: View, at: Point): string {
  const { x, y } = toScreen(view, at);
  const isLeft = x > view.width / 2;
  return `translate(${x + (isLeft ? -14 : 14)}px, ${y + 14}px) translate(${isLeft ? -100 : 0}%, 0)`;
}

/** Figures of a gesture; they change with every move, so they are not read out. */
export function Measures({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const measures = useStore(canvas, (state) => state.measures);
  const view = useStore(canvas, (state) => state.view);
  return measures.map(({ words, at }, index) => (
    // biome-ignore lint/suspicious/noArrayIndexKey: figures have no name
    <div key={index} className="canvas__message numbers" aria-hidden style={{ transform: beside(view, at) }}>
      {words}
    </div>
  ));
}

/** What was said beside a place: `2 of 3 here`. */
export function Message({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const message = useStore(canvas, (state) => state.message);
  const view = useStore(canvas, (state) => state.view);
  return (
    <div
      className={message === null ? 'canvas__message unseen' : 'canvas__message'}
      role="status"
      aria-label="At this place"
      style={message === null ? {} : { transform: beside(view, message.at) }}
    >
      {message?.words}
    </div>
  );
}

/** How many objects are hidden, with the way to show them. */
export function HiddenNote() {
  const { commands } = useEditor();
  const count = useDocument(({ file }) => hiddenIn(file).size);
  const isEditing = useSession(({ mode }) => mode === 'edit');
  if (count === 0 || !isEditing) return null;
  const what = count === 1 ? '1 object hidden: the run still meets it' : `${count} objects hidden: the run still meets them`;
  return (
    <div className="canvas__hidden" role="status" aria-label="Hidden objects">
      <EyeOff size={14} aria-hidden /> {what}
      <Button hint="Show all hidden objects" look="outlined" onClick={() => commands.run('object.show-all')}>
        Show
      </Button>
    </div>
  );
}
