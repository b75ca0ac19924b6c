import { useId, useState } from 'react';
import { useStore } from 'zustand';
import type { AccuracyName } from '../../engine/index.ts';
import { rendererOf } from '../canvas/index.ts';
import { keyLabel } from '../core/commands/index.ts';
import { IS_MAC, useEditor, useOverlay, usePageTerms } from '../core/context/index.ts';
import type { Settings } from '../core/settings/index.ts';
import { Button, Dialog, NumberField } from '../core/ui/index.ts';

const ACCURACY_HINTS: Readonly<Record<AccuracyName, string>> = {
  arcade: 'arcade: the original game, frame by frame',
  fast: 'fast: Verlet, 60 Hz',
  standard: 'standard: Runge-Kutta, 60 Hz',
  precise: 'precise: to a billionth of a px',
};

/** The choice of no accuracy but that of the folder. */
const AS_CHECKED = 'as checked';

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: T;
  readonly options: readonly (readonly [value: T, title: string])[];
  readonly onChange: (value: T) => void;
}

function Choice<T extends string>({ label, value, options, onChange }: ChoiceProps<T>) {
  const id = useId();
  return (
    <div className="setting">
      <label htmlFor={id}>{label}</label>
      <select id={id} className="field" value={value} onChange={(event) => onChange(event.target.value as T)}>
        {options.map(([option, title]) => (
          <option key={option} value={option}>
            {title}
          </option>
        ))}
      </select>
    </div>
  );
}

function Check({ label, checked, onChange }: { label: string; checked: boolean; onChange: (on: boolean) => void }) {
  return (
    <label className="setting setting--check">
      <input type="checkbox" checked={checked} onChange={(event) => onChange(event.target.checked)} />
      {label}
    </label>
  );
}

const RENDERERS = [
  ['automatic', 'automatic: WebGL if available'],
  ['webgl', 'WebGL'],
  ['canvas', 'Canvas'],
] as const;

/** The renderer. A page keeps the one it started with, so a change takes effect after a reload. */
function RendererSetting() {
  const editor = useEditor();
  const { settings, workspace } = editor;
  const wanted = useStore(settings, (state) => state.renderer);
  const now = rendererOf(editor);
  const reload = async () => {
    await workspace.store.getState().opened?.saver.flush();
    window.location.reload();
  };
  return (
    <>
      <Choice label="Renderer" value={wanted} options={RENDERERS} onChange={(renderer) => settings.setState({ renderer })} />
      {now?.setting === null && (
        <p className="setting__note">
          {`The address of this page sets the renderer to ${now.name === 'webgl' ? 'WebGL' : 'Canvas'}, which overrides this setting.`}
        </p>
      )}
      {now !== null && now.setting !== null && now.setting !== wanted && (
        <div className="setting">
          <span role="status">Takes effect after a reload.</span>
          <Button hint="Save, then reload the page" look="outlined" onClick={() => void reload()}>
            Reload
          </Button>
        </div>
      )}
    </>
  );
}

/** The user's preferences; they take effect at once and are kept in this browser. */
export function SettingsDialog() {
  const { settings: store } = useEditor();
  const dialog = useOverlay('settings');
  const settings = useStore(store);
  const { folder } = usePageTerms();
  const [listening, setListening] = useState(false);
  const set = (change: Partial<Settings>) => store.setState(change);
  return (
    <Dialog {...dialog} title="Settings" about="Kept in this browser, never written to level files.">
      <div className="settings">
        <Choice
          label="Theme"
          value={settings.theme}
          options={[
            ['system', 'same as the system'],
            ['dark', 'dark'],
            ['light', 'light'],
          ]}
          onChange={(theme) => set({ theme })}
        />
        <Choice
          label="Motion"
          value={settings.reduceMotion}
          options={[
            ['system', 'same as the system'],
            ['no', 'full'],
            ['yes', 'reduced'],
          ]}
          onChange={(reduceMotion) => set({ reduceMotion })}
        />
        <RendererSetting />
        <Choice
          label="Accuracy"
          value={settings.otherAccuracy ?? AS_CHECKED}
          options={[
            [AS_CHECKED, `as gq check here: ${folder.accuracy.name}`],
            ...Object.entries(ACCURACY_HINTS).map(([name, hint]) => [name as AccuracyName, hint] as const),
          ]}
          onChange={(name) => set({ otherAccuracy: name === AS_CHECKED ? null : name })}
        />
        <div className="setting">
          <NumberField label="Grid" value={settings.grid} min={1} max={256} whole unit="px" onChange={(grid) => set({ grid })} />
        </div>
        <Check label="Snap to the grid" checked={settings.snapToGrid} onChange={(snapToGrid) => set({ snapToGrid })} />
        <Check
          label="Snap to other objects"
          checked={settings.snapToObjects}
          onChange={(snapToObjects) => set({ snapToObjects })}
        />
        <Check
          label="Show the run's path in a playtest"
          checked={settings.runInPlay}
          onChange={(runInPlay) => set({ runInPlay })}
        />
        <Check label="Sound" checked={settings.sound} onChange={(sound) => set({ sound })} />
        <div className="setting">
          <label htmlFor="volume">Volume</label>
          <input
            id="volume"
            type="range"
            min={0}
            max={1}
            step={0.05}
            value={settings.volume}
            onChange={(event) => set({ volume: Number(event.target.value) })}
          />
        </div>
        <div className="setting">
          <span>Gun key in a playtest</span>
          <Button
            hint="Click, then press the key for the gun"
            look="outlined"
            pressed={listening}
            onClick={() => setListening(true)}
            onBlur={() => setListening(false)}
            onKeyDown={(event) => {
              if (!listening) return;
              event.preventDefault();
              event.stopPropagation();
              if (event.key !== 'Escape') set({ gunKey: event.code });
              setListening(false);
            }}
          >
            {listening ? 'press a key' : keyLabel(settings.gunKey, IS_MAC)}
          </Button>
        </div>
      </div>
    </Dialog>
  );
}
