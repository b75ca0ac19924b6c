import { Copy } from 'lucide-react';
import { type KeyboardEvent, useEffect, useId, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor, useLevel } from '../../core/context/index.ts';
import { copyText } from '../../core/exchange/index.ts';
import { Button } from '../../core/ui/index.ts';
import { SCRIPT_FIELD } from './index.ts';
import { draftsOf, dropDraft, endScript, remarksInWords, scriptText, shownDraft, typeScript } from './script-draft.ts';
import './script.css';

/** lines of the field; longer texts scroll */
const LINES = { least: 2, most: 9 } as const;
/** characters that fit on a line of the panel, about */
const WIDTH = 30;

const linesOf = (text: string): number => {
  const lines = text.split('\n').reduce((sum, line) => sum + Math.max(1, Math.ceil(line.length / WIDTH)), 0);
  return Math.min(LINES.most, Math.max(LINES.least, lines));
};

/** The holds and notes of a run as text: typing changes the run, and editing the run elsewhere changes the text. */
export function ScriptField({ run }: { readonly run: string }) {
  const { notices } = useEditor();
  const level = useLevel();
  const id = useId();
  const field = useRef<HTMLTextAreaElement>(null);
  const [isTyping, setTyping] = useState(false);
  // what was done with the last text stays said when it has become canonical
  const [said, setSaid] = useState<{ readonly of: string; readonly words: readonly string[] } | null>(null);
  const script = useDocument(({ file }) => file.runs?.find(({ name }) => name === run));
  const canonical = script === undefined ? '' : scriptText(level.document.file(), run);
  const draft = shownDraft(
    useStore(draftsOf(level), (drafts) => drafts.get(run)),
    canonical,
  );
  const text = draft?.text ?? canonical;
  const mistake = draft !== null && !draft.reading.ok ? draft.reading : null;
  // while a hold is being typed, its missing end is no mistake yet
  const isUnfinished = mistake !== null && isTyping && mistake.offset >= text.trimEnd().length;
  const remarks = draft !== null ? remarksInWords(draft.reading) : said?.of === canonical ? said.words : [];

  // another run, or the panel goes: what was typed is one step
  useEffect(() => () => endScript(level, run), [level, run]);

  const leave = () => {
    setTyping(false);
    setSaid(remarks.length === 0 ? null : { of: canonical, words: remarks });
    endScript(level, run);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== 'Escape' || draft === null) return;
    event.stopPropagation();
    level.document.seal();
    dropDraft(level, run);
  };
  const goTo = (offset: number) => {
    field.current?.focus();
    field.current?.setSelectionRange(offset, offset);
  };
  return (
    <section className="script" aria-label="Run as text">
      <div className="script__head">
        <label htmlFor={SCRIPT_FIELD}>Holds of {run} as text</label>
        <Button
          hint="Copy the run as text"
          icon={<Copy size={13} />}
          onClick={() => void copyText(notices, 'the run as text', text)}
        />
      </div>
      <textarea
        ref={field}
        id={SCRIPT_FIELD}
        className="field numbers script__text"
        rows={linesOf(text)}
        value={text}
        spellCheck={false}
        autoCapitalize="off"
        autoComplete="off"
        placeholder="60-150, 200-410 # first swing"
        aria-invalid={mistake !== null && !isUnfinished}
        aria-describedby={`${id}-how${mistake === null ? '' : ` ${id}-mistake`}`}
        onFocus={() => setTyping(true)}
        onChange={(event) => typeScript(level, run, event.target.value)}
        onKeyDown={onKeyDown}
        onBlur={leave}
      />
      <p id={`${id}-how`} className="script__how">
        Ticks of 1/60 s, or seconds: 1s-2.5s. # begins a note.
      </p>
      {mistake !== null && (
        <div
          id={`${id}-mistake`}
          className={isUnfinished ? 'script__mistake script__mistake--unfinished' : 'script__mistake'}
          // not while every letter changes it: then the field is described by it
          role={isTyping ? undefined : 'alert'}
        >
          <button type="button" className="script__place" onClick={() => goTo(mistake.offset)}>
            {mistake.line}:{mistake.column}
          </button>
          <span>
            {mistake.message}. {mistake.hint} The run is as it was; Esc restores its text.
          </span>
        </div>
      )}
      <div role="status" aria-label="What was done with the text" className="script__remarks">
        {remarks.map((words) => (
          <p key={words}>{words}</p>
        ))}
      </div>
    </section>
  );
}
