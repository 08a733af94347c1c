"""Where a black box is evaluated: in this thread, in others, in processes, on a cluster."""

from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from multiprocessing import get_context

from distributed import Client, LocalCluster


@contextmanager
def threads():
    with ThreadPoolExecutor(2) as executor:
        yield {"executor": executor, "in_flight": 2}


@contextmanager
def processes():
    with ProcessPoolExecutor(2, mp_context=get_context("fork")) as executor:
        yield {"executor": executor, "in_flight": 3}


@contextmanager
def dask():
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster,
        Client(cluster) as client,
        client.get_executor() as executor,
    ):
        executor.submit(abs, 0).result()  # it starts threads
        yield {"executor": executor, "in_flight": 3}


PLACES = {
    "here": lambda: nullcontext({}),
    "here, in batches": lambda: nullcontext({"batch": 3}),
    "jobs": lambda: nullcontext({"jobs": 2}),
    "jobs, in batches": lambda: nullcontext({"jobs": 2, "batch": 2, "in_flight": 3}),
    "threads": threads,
    "processes": processes,
    "dask": dask,
}
