! A program in Fortran 2003: half an orbit of a planet.
! SPDX-License-Identifier: GPL-2.0-or-later
program half_an_orbit
    use, intrinsic :: iso_c_binding
    implicit none

    interface
        integer(c_int) function kepler_create(parameters, count, handle) bind(c)
            import :: c_int, c_double, c_size_t, c_ptr
            real(c_double), intent(in) :: parameters(*)
            integer(c_size_t), value :: count
            type(c_ptr), intent(out) :: handle
        end function
        integer(c_int) function kepler_destroy(handle) bind(c)
            import :: c_int, c_ptr
            type(c_ptr), value :: handle
        end function
        integer(c_int) function kepler_initial(handle, state) bind(c)
            import :: c_int, c_double, c_ptr
            type(c_ptr), value :: handle
            real(c_double), intent(out) :: state(*)
        end function
        integer(c_int) function kepler_step(handle, state, h) bind(c)
            import :: c_int, c_double, c_ptr
            type(c_ptr), value :: handle
            real(c_double), intent(inout) :: state(*)
            real(c_double), value :: h
        end function
        integer(c_int) function kepler_integrate(handle, state, t, h, steps, every, columns, &
                buffer, rows, written) bind(c)
            import :: c_int, c_double, c_size_t, c_ptr, c_char
            type(c_ptr), value :: handle
            real(c_double), intent(inout) :: state(*)
            real(c_double), value :: t, h
            integer(c_size_t), value :: steps, every, rows
            character(kind=c_char), intent(in) :: columns(*)
            real(c_double), intent(out) :: buffer(*)
            integer(c_size_t), intent(out) :: written
        end function
    end interface

    real(c_double), parameter :: ecc = 0.5_c_double, pi = acos(-1.0_c_double)
    integer(c_size_t), parameter :: steps = 400, rows = 4
    real(c_double) :: x(4), y(4), table(2, rows)
    integer(c_size_t) :: written
    integer :: k
    type(c_ptr) :: planet

    call check(kepler_create([1.0_c_double, ecc], 2_c_size_t, planet) == 0, 'create')
    call check(kepler_initial(planet, x) == 0, 'initial')
    y = x
    call check(kepler_integrate(planet, x, 0.0_c_double, pi/steps, steps, steps/rows, &
        't, x' // c_null_char, table, rows, written) == 0, 'integrate')
    call check(written == rows, 'rows')
    call check(abs(x(1) + 1 + ecc) < 1e-12_c_double, 'half an orbit')
    call check(table(2, rows) == x(1), 'the last row')
    do k = 1, int(steps)
        call check(kepler_step(planet, y, pi/steps) == 0, 'step')
    end do
    call check(all(x == y), 'steps one by one')
    call check(kepler_destroy(planet) == 0, 'destroy')
    call check(kepler_destroy(planet) /= 0, 'a handle twice')

contains

    subroutine check(is_right, what)
        logical, intent(in) :: is_right
        character(len=*), intent(in) :: what
        if (is_right) return
        print *, 'wrong: ', what
        stop 1
    end subroutine
end program
