import { element } from './dom.ts';

export interface PanelContent {
  readonly title: string;
  readonly body: readonly HTMLElement[];
  /** The first one gets the focus. */
  readonly buttons: readonly (HTMLElement | null)[];
  readonly below?: readonly HTMLElement[];
}

/** What is asked or said above a level: a dialog, of which there is one at a time. */
export class Panel {
  readonly root = element('dialog', { class: 'panel' });

  /** @param onCancel called when Esc is pressed in it */
  constructor(onCancel: () => void) {
    // a held key must not press the button that appears under it
    this.root.addEventListener('keydown', (event) => {
      if (event.repeat && (event.key === ' ' || event.key === 'Enter')) event.preventDefault();
    });
    this.root.addEventListener('cancel', (event) => {
      event.preventDefault();
      onCancel();
    });
  }

  get isOpen(): boolean {
    return this.root.open;
  }

  /** Shows a content. Changing it leaves the focus at the same place. */
  show({ title, body, buttons, below = [] }: PanelContent): void {
    const { root } = this;
    const focused = [...root.querySelectorAll('button')].indexOf(document.activeElement as HTMLButtonElement);
    const heading = element('h2', { id: 'panel-title' }, title);
    root.setAttribute('aria-labelledby', heading.id);
    root.replaceChildren(heading, ...body, element('div', { class: 'buttons' }, ...buttons), ...below);
    if (!root.open) root.showModal();
    root.querySelectorAll('button')[Math.max(0, focused)]?.focus();
  }

  close(): void {
    if (this.root.open) this.root.close();
    this.root.replaceChildren();
  }
}
