export type ToWorker =
  | { readonly type: 'start'; readonly job: number; readonly kind: string; readonly request: unknown }
  | { readonly type: 'cancel'; readonly job: number };

export type FromWorker =
  | { readonly type: 'progress'; readonly job: number; readonly progress: unknown }
  | { readonly type: 'done'; readonly job: number; readonly result: unknown }
  | { readonly type: 'failed'; readonly job: number; readonly message: string }
  | { readonly type: 'cancelled'; readonly job: number };
